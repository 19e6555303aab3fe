// mutation/mutations: each operator on a short text, what must not be touched, and ids.
#include "mutations.h"
#include "surroundings.h"

TestSuite(mutate);

// Is there a mutation of `text` with this id, and does it make this of the text?
static void expect_mutant(const char *text, const char *id, const char *expected)
{
    Mutations mutations;
    cr_assert_eq(mutations_find(text, &mutations), 0);
    int n_found = 0;
    for (int i = 0; i < mutations.n; i++) {
        if (strcmp(mutations.all[i].id, id) == 0) {
            char *mutant = mutation_apply(text, &mutations.all[i]);
            cr_expect_str_eq(mutant, expected);
            free(mutant);
            n_found++;
        }
    }
    cr_expect_eq(n_found, 1, "\"%s\": found %d mutations called %s, expected 1", text, n_found, id);
    mutations_free(&mutations);
}

static int count_mutants(const char *text)
{
    Mutations mutations;
    cr_assert_eq(mutations_find(text, &mutations), 0);
    const int n = mutations.n;
    mutations_free(&mutations);
    return n;
}

// ---- Operators ----------------------------------------------------------------------------------

Test(mutate, operators_between_two_terms)
{
    expect_mutant("f = a + b;", "3:operator:+:-", "f = a - b;");
    expect_mutant("f = a * (b);", "3:operator:*:/", "f = a / (b);");
    expect_mutant("f = a && b;", "3:operator:&&:||", "f = a || b;");
    expect_mutant("i++;", "1:operator:++:--", "i--;");
    expect_mutant("a[i] -= b;", "4:operator:-=:+=", "a[i] += b;");
}

Test(mutate, a_sign_before_a_term_is_left_out)
{
    expect_mutant("f = -b;", "2:operator:-:none", "f = b;");
    expect_mutant("f = !b;", "2:operator:!:none", "f = b;");
    // An address and what a pointer points to are no arithmetic.
    cr_expect_eq(count_mutants("f(&a, &a);"), 1);  // the call left out
}

Test(mutate, comparisons_move_by_their_border_and_turn_round)
{
    expect_mutant("f = a < b;", "3:compare:<:<=", "f = a <= b;");
    expect_mutant("f = a < b;", "3:compare:<:>", "f = a > b;");
    expect_mutant("f = a == b;", "3:compare:==:!=", "f = a != b;");
}

Test(mutate, constants_go_up_down_to_twice_and_to_nothing)
{
    expect_mutant("f = 3u;", "2:constant:3u:4u", "f = 4u;");
    expect_mutant("f = 3u;", "2:constant:3u:2u", "f = 2u;");
    expect_mutant("f = 3u;", "2:constant:3u:0u", "f = 0u;");
    expect_mutant("f = 0;", "2:constant:0:1", "f = 1;");
    expect_mutant("f = 0.5f;", "2:constant:0.5f:1.00000000f", "f = 1.00000000f;");
    expect_mutant("f = 0.5f;", "2:constant:0.5f:0.00000000f", "f = 0.00000000f;");
    expect_mutant("f = INFINITY;", "2:constant:INFINITY:0.0f", "f = 0.0f;");
    expect_mutant("f = KD_LEAF;", "2:constant:KD_LEAF:+1", "f = (KD_LEAF + 1);");
}

Test(mutate, arguments_change_places_with_their_neighbours)
{
    expect_mutant("f(a, g(b, c), d);", "2:swap:a:1", "f(g(b, c), a, d);");
    expect_mutant("f(a, g(b, c), d);", "4:swap:g:2", "f(a, d, g(b, c));");
    expect_mutant("f(a, g(b, c), d);", "6:swap:b:1", "f(a, g(c, b), d);");
    expect_mutant("v = (float2)(a, b);", "6:swap:a:1", "v = (float2)(b, a);");
    expect_mutant("int v[] = {a, b};", "6:swap:a:1", "int v[] = {b, a};");
}

Test(mutate, no_arguments_are_swapped_where_order_does_not_count)
{
    cr_expect_eq(count_mutants("int k = fmin(m, n);"), 1);  // the one that has fmax instead
}

Test(mutate, statements_are_dropped)
{
    expect_mutant("a = b; c();", "4:drop:c", "a = b; ;");
    expect_mutant("if (a) return; b = c;", "4:drop:return", "if (a) ; b = c;");
    expect_mutant("if (a) { b(); c(); }", "4:drop:{", "if (a) {\n}");
    expect_mutant("switch (a) { case 1: b(); }", "8:drop:b", "switch (a) { case 1: ; }");
}

Test(mutate, declarations_and_the_last_return_are_not_dropped)
{
    cr_expect_eq(count_mutants("int k = n;"), 0);
    cr_expect_eq(count_mutants("const int k = (int)n;"), 0);
    cr_expect_eq(count_mutants("return a;"), 0);
}

Test(mutate, conditions_are_negated)
{
    expect_mutant("if (a) { }", "2:negate:a:if", "if (!(a)) { }");
    expect_mutant("while (a(b)) { }", "2:negate:a:while", "while (!(a(b))) { }");
    expect_mutant("c = f(a == b) ? d : e;", "2:negate:f:?", "c = !(f(a == b)) ? d : e;");
}

Test(mutate, names_are_taken_for_their_partners)
{
    expect_mutant("f = a.x;", "4:name:x:y", "f = a.y;");
    expect_mutant("f = a->y;", "4:name:y:z", "f = a->z;");
    expect_mutant("f = min(a, b);", "2:name:min:max", "f = max(a, b);");
    cr_expect_eq(count_mutants("int f = y;"), 1);  // a number has no z
}

Test(mutate, a_call_with_one_argument_is_its_argument)
{
    expect_mutant("f = g(a);", "2:unwrap:g", "f = (a);");
    cr_expect_eq(count_mutants("int f = sizeof(a);"), 0);
}

// ---- Stability ----------------------------------------------------------------------------------

Test(mutate, comments_blanks_and_strings_change_no_id)
{
    const char *plain = "if (a < 1) { b(c, d); e += 2; }";
    const char *commented = "// x < 2\n  if (a\n<1)/* + */{b( c,d);\n#pragma x + y\n e+=2;}";
    Mutations one, other;
    cr_assert_eq(mutations_find(plain, &one), 0);
    cr_assert_eq(mutations_find(commented, &other), 0);
    cr_assert_eq(one.n, other.n);
    cr_expect_gt(one.n, 8);
    for (int i = 0; i < one.n; i++) {
        cr_expect_str_eq(one.all[i].id, other.all[i].id);
    }
    mutations_free(&one);
    mutations_free(&other);
}

Test(mutate, no_id_is_there_twice_and_no_mutant_is_the_text_itself)
{
    const char *text = "for (int i = 0; i < n; i++) { f(a.x, a.y, 2.0f); g = -h ? MAX : -1; }";
    Mutations mutations;
    cr_assert_eq(mutations_find(text, &mutations), 0);
    for (int i = 0; i < mutations.n; i++) {
        for (int j = 0; j < i; j++) {
            cr_expect_str_neq(mutations.all[i].id, mutations.all[j].id);
        }
        char *mutant = mutation_apply(text, &mutations.all[i]);
        cr_expect_str_neq(mutant, text, "%s", mutations.all[i].id);
        free(mutant);
    }
    mutations_free(&mutations);
}
