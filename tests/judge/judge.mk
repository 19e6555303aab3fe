# How the judge is built. It knows the answers: never in a handout as text, and never linked with what
# starts a student's code.

JUDGE_ROOMS := tests/judge $(patsubst %/,%,$(wildcard tests/judge/*/))
JUDGE_SOURCES := $(filter-out %/judge_tool.c %/one_judge.c,$(foreach room,$(JUDGE_ROOMS),$(wildcard $(room)/*.c)))
# Judges of later labs get their trees and cameras from the solutions of labs 02, 04 and 06.
BUILDERS := $(wildcard solutions/02-kdtree-2d-build/kdtree2d_build.c \
    solutions/04-camera-rays/camera_from_view.c solutions/06-kdtree-3d-build/kdtree3d_build.c)
BUILDER_INCLUDES = $(addprefix -I ,$(sort $(dir $(BUILDERS))))
AUTHORS_INCLUDES += $(addprefix -I ,$(JUDGE_ROOMS) tests/stand_ins) $(BUILDER_INCLUDES)

# Every ray asks every sphere, in nearly every test of a judge.
$(OUT)/obj/tests/judge/oracles/%.o: OPTIMISATION = -O3 -g -fno-math-errno

$(OUT)/libjudge.a: $(call objects,$(JUDGE_SOURCES) $(BUILDERS))
	$(archive)

# The table of judges, anew when a lab comes or goes.
JUDGE_NUMBERS := $(sort $(patsubst judge_%.c,%,$(notdir $(wildcard tests/judge/[0-9]*/judge_[0-9][0-9].c))))
$(OUT)/obj/tests/judge/judges.c.o: EXTRA = $(GRADER_INCLUDES) -D'JUDGES=$(patsubst %,JUDGE(%),$(JUDGE_NUMBERS))'
$(OUT)/obj/tests/judge/judges.c.o: tests/judge

# What the judge needs besides: no file is read by it, no device opened.
JUDGE_NEEDS = $(addprefix common/,$(addsuffix .c,cl_check clean_text complain image message number scene2d \
    scene2d_edge_cases scene2d_generate scene2d_random scene3d scene3d_edge_cases scene3d_generate \
    scene3d_lattice scene3d_random scene3d_sphereflake scene3d_uneven scene3d_view scene_arguments tree2d tree2d_draw tree2d_grow \
    tree3d tree3d_draw tree3d_grow utf8)) \
    $(addprefix tests/grader/verdict/,diagnosis.c result.c) tests/judge/judge_tool.c tests/probes/sections.c
# Linked statically: it runs wherever a handout that holds it is unpacked.
$(OUT)/tools/judge: $(call objects,$(JUDGE_NEEDS)) $(OUT)/libjudge.a
	$(call link,$(if $(SANITIZERS),,-static) -lm)

# The same for handouts, which go to machines of both kinds, each with the judge of its lab alone.
LAB_JUDGES = $(JUDGE_NUMBERS:%=$(OUT)/tools/judge-%)
$(OUT)/obj/only/%.o: tests/judge/one_judge.c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS) $(AUTHORS_INCLUDES) $(GRADER_INCLUDES) -DTHE_JUDGE=judge_$*, for lab $*)
$(LAB_JUDGES): $(OUT)/tools/judge-%: $(OUT)/obj/only/%.o $(call objects,$(JUDGE_NEEDS)) $(OUT)/libjudge.a
	$(call link,-static-pie -lm)
# What a handout holds is judges/x86_64/tools/judge-NN or judges/aarch64/tools/judge-NN. It should take work
# to take it apart: the linker melts all of the program's files into one, in which no function has to be where
# its source had it, or has a name; and no address in it is fixed. That it cannot be taken apart, nobody
# promises (tests/what-protects-a-grade.md). One partition, no debugging text and no build id: the same bytes
# wherever it is built.
JUDGES = $(addprefix $(OUT)/judges/,x86_64 aarch64)
MELTED = -O2 -flto -fPIE -fvisibility=hidden -ffunction-sections -fdata-sections
.PHONY: lab-judges $(JUDGES)
lab-judges: $(LAB_JUDGES)
$(JUDGES): $(OUT)/judges/%:
	@command -v $*-linux-gnu-gcc >/dev/null || { \
	    echo "make: found no $*-linux-gnu-gcc, expected one: make handout installs it" >&2; exit 2; }
	@$(MAKE) --no-print-directory BUILD=$(OUT)/judges/$* CC=$*-linux-gnu-gcc AR=$*-linux-gnu-gcc-ar \
	    OPTIMISATION='$(MELTED)' LDFLAGS='-flto -flto-partition=one -s -Wl,--gc-sections,--build-id=none' lab-judges
