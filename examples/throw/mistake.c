#include "throw/mistake.h"

#include <string.h>

static const struct {
    const char *name, *wanted;
} mistakes[] = {
    [THROW_NO_MISTAKE] = {"", ""},
    [THROW_REVERSED] = {"granny", "a throw of the same handedness as the one below: granny"},
    [THROW_TO_HANDLE] = {"handle", "turns that would tie nothing, and tie nothing"},
    [THROW_COUNTER] = {"counter", "too few turns to tie anything, and nothing is tied"},
    [THROW_BIGHT] = {"bight",
                     "nothing is tied, though the tail was drawn until the turns were off"},
    [THROW_DROPPED] = {"dropped", "the throw would have been tied, and is not"},
    [THROW_ONE_SIDED] = {"one-sided", "the throw is tied, and is a half hitch"},
};
enum { MISTAKES = sizeof mistakes / sizeof mistakes[0] };

const char *mistake_name(throw_mistake mistake)
{
    return mistakes[mistake].name;
}

const char *mistake_wanted(throw_mistake mistake)
{
    return mistakes[mistake].wanted;
}

throw_mistake mistake_named(const char *name)
{
    int i = 1;
    while (i < MISTAKES && strcmp(mistakes[i].name, name) != 0) {
        i++;
    }
    return i < MISTAKES ? (throw_mistake)i : THROW_NO_MISTAKE;
}

bool mistake_is_reported(throw_mistake mistake, const trial_outcome *out, uint32_t throws,
                         int wraps)
{
    const vbss_knot_state *k = &out->knot.state, *next = &out->predicted.state;
    bool as_meant = next->next_verdict == VBSS_KNOT_VERDICT_PASSED && next->next_wraps == wraps;
    bool tied = k->throw_count == throws && k->verdict == VBSS_KNOT_VERDICT_CERTIFIED;
    bool proved_less = k->throw_count == throws - 1 && k->certified == 1;
    switch (mistake) {
    case THROW_REVERSED:
        return tied && (k->faults & VBSS_KNOT_FAULT_GRANNY) != 0;
    case THROW_TO_HANDLE:
    case THROW_COUNTER:
        return proved_less && next->next_verdict != VBSS_KNOT_VERDICT_PASSED &&
               next->next_wraps == 0;
    case THROW_BIGHT:
        return proved_less;
    case THROW_DROPPED:
        return proved_less && as_meant;
    case THROW_ONE_SIDED:
        return tied && as_meant && (k->faults & VBSS_KNOT_FAULT_HITCH) != 0 &&
               (k->faults & VBSS_KNOT_FAULT_GRANNY) == 0;
    default:
        return false;
    }
}
