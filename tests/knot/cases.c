#include "knot/cases.h"

#include <stdlib.h>

enum { SEEDS = 6 };

judge cases_judge;

static family_case *cases;
static uint32_t case_count;

static void make_cases(void)
{
    for (int f = 0; f < FAMILIES; f++) {
        for (uint64_t seed = 0; seed < SEEDS; seed++) {
            family_case *made = &cases[case_count];
            uint32_t segments = seed % 2 == 0 ? 240 : 130;
            if (families[f].make(100 + 7 * seed, segments, made) && made->truth != FAMILY_OPEN) {
                case_count++;
            }
        }
    }
}

int begin_cases(void **state)
{
    (void)state;
    judge_begin(&cases_judge);
    cases = malloc((size_t)FAMILIES * SEEDS * sizeof *cases);
    if (cases == NULL || !judge_make(&cases_judge)) {
        return 1;
    }
    make_cases();
    return 0;
}

int end_cases(void **state)
{
    (void)state;
    judge_end(&cases_judge);
    free(cases);
    return 0;
}

void cases_hear(const family_case *c, judge_saying *saying)
{
    vbss_knot_input in = judge_input_of(&c->line);
    expect_ok(judge_hear(&cases_judge, &in, saying));
}

void on_all_cases(cases_check holds)
{
    assert_true(case_count >= (FAMILIES - 1) * SEEDS * 9 / 10);
    for (uint32_t i = 0; i < case_count; i++) {
        holds(&cases[i]);
    }
}
