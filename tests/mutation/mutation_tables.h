// Which word a mutation puts in another's place: "found", "put instead". For mutations.c.
#ifndef GRADER_MUTATION_TABLES_H
#define GRADER_MUTATION_TABLES_H

// clang-format off
static const char *const OPERATORS[][2] = {
    {"+", "-"},   {"-", "+"},   {"*", "/"},   {"/", "*"},   {"%", "/"},   {"&&", "||"},
    {"||", "&&"}, {"&", "|"},   {"|", "&"},   {"++", "--"}, {"--", "++"}, {"+=", "-="},
    {"-=", "+="}, {"*=", "/="}, {"/=", "*="}, {"<<", ">>"}, {">>", "<<"},
};

static const char *const COMPARISONS[][2] = {
    {"<", "<="}, {"<", ">"},  {"<=", "<"},  {"<=", ">="}, {">", ">="},
    {">", "<"},  {">=", ">"}, {">=", "<="}, {"==", "!="}, {"!=", "=="},
};

// The solutions' own words, whose partners students mix up.
static const char *const NAMES[][2] = {
    {"x", "y"}, {"y", "x"}, {"r", "g"}, {"g", "b"}, {"b", "r"}, {"dx", "dy"}, {"dy", "dx"},
    {"dz", "dx"}, {"fmin", "fmax"}, {"fmax", "fmin"}, {"fminf", "fmaxf"}, {"fmaxf", "fminf"},
    {"min", "max"}, {"max", "min"}, {"sin", "cos"}, {"cos", "sin"}, {"minX", "maxX"},
    {"maxX", "minX"}, {"minY", "maxY"}, {"maxY", "minY"}, {"minX", "minY"}, {"minY", "minX"},
    {"maxX", "maxY"}, {"maxY", "maxX"}, {"width", "height"}, {"height", "width"},
    {"left", "right"}, {"right", "left"}, {"up", "right"}, {"forward", "up"},
    {"lChild", "rChild"}, {"rChild", "lChild"}, {"t_near", "t_far"}, {"t_far", "t_near"},
    {"t_low", "t_high"}, {"t_high", "t_low"}, {"t_min", "t_max"}, {"t_max", "t_min"},
    {"near_child", "far_child"}, {"far_child", "near_child"}, {"ONLY_NEAR", "ONLY_FAR"},
    {"ONLY_FAR", "ONLY_NEAR"}, {"BOTH", "ONLY_NEAR"}, {"CL_TRUE", "CL_FALSE"},
    {"origin", "direction"}, {"direction", "origin"},
};

// Of what stands behind a point or an arrow only.
static const char *const MEMBERS[][2] = {{"y", "z"}, {"z", "x"}};
// clang-format on

#endif
