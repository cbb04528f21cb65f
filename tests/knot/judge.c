/* Asking a detector, and counting what it says. */
#include "knot/judge.h"

#include "base/error.h"

#include <stdio.h>
#include <string.h>

/* ---- asking */

void judge_begin(judge *j)
{
    memset(j, 0, sizeof *j);
    (void)vbss_knot_detector_config_init(&j->config, sizeof j->config);
    j->config.point_capacity = STACK_POINTS;
    j->config.tool_capacity = 0;
}

bool judge_make(judge *j)
{
    return vbss_context_create(NULL, &j->context) == VBSS_OK &&
           vbss_knot_detector_create(j->context, &j->config, &j->detector) == VBSS_OK;
}

void judge_end(judge *j)
{
    (void)vbss_context_destroy(j->context);
}

/* Where the detector sees the tissue when it is shown both holes: the truth is about that place. Points given twice do
 * not count. */
static bool lies_between_holes(const thread_line *line)
{
    bool plain = 0.5 * (line->hole_places[0] + line->hole_places[1]) == line->tissue_place;
    for (uint32_t i = (uint32_t)line->hole_places[0]; i < line->hole_places[1] && plain; i++) {
        plain = vec3_distance(line->x[i], line->x[i + 1]) > 0.0;
    }
    return plain;
}

vbss_knot_input judge_input_of(const thread_line *line)
{
    vbss_knot_input in;
    (void)vbss_knot_input_init(&in, sizeof in);
    in.point_count = line->count;
    in.points = &line->x[0].x;
    if (line->tissue_place < 0.0) {
        return in;
    }
    vec3_store(in.away, line->away);
    in.hole_count = 2;
    for (int i = 0; i < 2; i++) {
        in.hole_places[i] = line->hole_places[i];
        vec3_store(in.holes[i], line->holes[i]);
    }
    if (!lies_between_holes(line)) {
        in.hole_count = 1;
        in.hole_places[0] = line->tissue_place;
        vec3_store(in.holes[0], thread_line_at(line, line->tissue_place));
    }
    return in;
}

vbss_result judge_hear(judge *j, const vbss_knot_input *input, judge_saying *s)
{
    memset(s, 0, sizeof *s);
    VBSS_TRY(vbss_knot_detector_reset(j->detector));
    VBSS_TRY(vbss_knot_detector_judge(j->detector, input));
    VBSS_TRY(vbss_knot_detector_get_state(j->detector, &s->state, sizeof s->state));
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        VBSS_TRY(vbss_knot_detector_get_throw(j->detector, i, &s->throws[i], sizeof s->throws[i]));
    }
    return vbss_knot_detector_get_notation(j->detector, s->notation, sizeof s->notation);
}

bool judge_is_uncertain(const judge_saying *s)
{
    return s->state.verdict == VBSS_KNOT_VERDICT_UNCERTAIN;
}

bool judge_is_certified(const judge_saying *s)
{
    bool none = s->state.verdict == VBSS_KNOT_VERDICT_NONE && s->state.certified != 0;
    return none || s->state.verdict == VBSS_KNOT_VERDICT_CERTIFIED;
}

static bool has(const vbss_knot_throw *t, uint32_t flag)
{
    return (t->flags & flag) != 0;
}

bool judge_is_ordered(const judge_saying *s)
{
    bool ordered = true;
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        ordered = ordered && (has(&s->throws[i], VBSS_KNOT_THROW_STRAY) ||
                              has(&s->throws[i], VBSS_KNOT_THROW_ORDERED));
    }
    return ordered;
}

/* ---- counting */

void judge_count(judge_counts *counts, const judge_saying *s, const family_case *c, bool tail_last,
                 const char *what)
{
    if (c->truth == FAMILY_OPEN) {
        counts->untrue++;
        return;
    }
    const char *fault = judge_fault(s, c, tail_last);
    bool uncertain = judge_is_uncertain(s);
    if ((fault != NULL || uncertain) && counts->wrong + counts->uncertain == 0) {
        snprintf(counts->first, sizeof counts->first, "%s: %s, \"%s\"", what,
                 uncertain ? "uncertain" : fault, s->notation);
    }
    counts->heard++;
    counts->wrong += fault != NULL;
    counts->uncertain += uncertain;
    counts->certified += judge_is_certified(s);
    counts->ordered += !uncertain && c->truth == FAMILY_THROWS && judge_is_ordered(s);
    bool is_stack = c->truth == FAMILY_THROWS;
    counts->stacks += is_stack;
    counts->recognised += is_stack && fault == NULL && !uncertain;
    counts->proved += is_stack && judge_is_certified(s);
    bool located = c->truth == FAMILY_THROWS && !uncertain;
    for (uint32_t i = 0; i < s->state.throw_count && located; i++) {
        located = has(&s->throws[i], VBSS_KNOT_THROW_LOCATED);
    }
    counts->located += located;
}

void judge_add_up(judge_counts *sum, const judge_counts *counts)
{
    if (sum->wrong + sum->uncertain == 0) {
        memcpy(sum->first, counts->first, sizeof sum->first);
    }
    sum->heard += counts->heard;
    sum->wrong += counts->wrong;
    sum->uncertain += counts->uncertain;
    sum->certified += counts->certified;
    sum->ordered += counts->ordered;
    sum->located += counts->located;
    sum->untrue += counts->untrue;
    sum->stacks += counts->stacks;
    sum->recognised += counts->recognised;
    sum->proved += counts->proved;
}
