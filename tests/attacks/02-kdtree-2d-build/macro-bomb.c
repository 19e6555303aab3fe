// attack: a line that grows to ten million numbers in the compiler
// task: split_box
// named: compiler did not finish|memory|too large
// limit: 2
    (void)box;
#define A 1,1,1,1,1,1,1,1,1,1
#define B A,A,A,A,A,A,A,A,A,A
#define C B,B,B,B,B,B,B,B,B,B
#define D C,C,C,C,C,C,C,C,C,C
#define E D,D,D,D,D,D,D,D,D,D
#define F E,E,E,E,E,E,E,E,E,E
#define G F,F,F,F,F,F,F,F,F,F
    static const int numbers[] = {G};
    (void)numbers;
