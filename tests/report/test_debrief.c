/* What the report says would raise the score most, from sessions that are made of events alone. */
#include <stdio.h>
#include <string.h>

#include "harness/harness.h"
#include "report/page.h"

#define FILE_NAME "debrief.html"

static facts f;
static char written[16384];

static void add_event(vbss_session_event *e, double time, vbss_session_event_kind kind,
                      uint32_t number, uint32_t undone)
{
    memset(e, 0, sizeof *e);
    e->time = time;
    e->kind = kind;
    e->number = number;
    e->undone = undone;
}

/* The debrief of a session of 300 s with these events, as it is written. */
static const char *debrief(vbss_session_event *events, size_t count)
{
    memset(&f, 0, sizeof f);
    f.again.session.there = f.again.session.measured = true;
    f.again.session.events = events;
    f.again.session.count = count;
    f.again.session.status.time = 300.0;
    page *p = page_create();
    assert_non_null(p);
    page_debrief(p, &f);
    assert_true(page_write(p, FILE_NAME));
    page_destroy(p);
    FILE *in = fopen(FILE_NAME, "rb");
    assert_non_null(in);
    written[fread(written, 1, sizeof written - 1, in)] = '\0';
    fclose(in);
    return written;
}

/* The needle went in beside its mark at 10 s, the first throw began at 60 s, and nothing was mended. */
static void a_missed_hole_costs_time_until_the_first_throw_begins(void **state)
{
    (void)state;
    vbss_session_event e[2];
    add_event(&e[0], 10.0, VBSS_SESSION_EVENT_MISTAKE, VBSS_SESSION_MISTAKE_ENTRY_MISSED, 0);
    add_event(&e[1], 60.0, VBSS_SESSION_EVENT_PHASE, VBSS_SESSION_PHASE_THROW_1, 0);
    assert_non_null(strstr(debrief(e, 2), "<strong>50 points</strong>"));
}

static void a_mistake_that_lasts_costs_time_until_the_end(void **state)
{
    (void)state;
    vbss_session_event e[2];
    add_event(&e[0], 10.0, VBSS_SESSION_EVENT_MISTAKE, VBSS_SESSION_MISTAKE_SLACK, 0);
    add_event(&e[1], 60.0, VBSS_SESSION_EVENT_PHASE, VBSS_SESSION_PHASE_THROW_1, 0);
    assert_non_null(strstr(debrief(e, 2), "<strong>290 points</strong>"));
}

static void a_mistake_that_is_mended_twice_costs_both_times(void **state)
{
    (void)state;
    vbss_session_event e[4];
    const uint32_t lost = VBSS_SESSION_MISTAKE_TURNS_LOST;
    add_event(&e[0], 10.0, VBSS_SESSION_EVENT_MISTAKE, lost, 0);
    add_event(&e[1], 14.0, VBSS_SESSION_EVENT_MISTAKE, lost, 1);
    add_event(&e[2], 20.0, VBSS_SESSION_EVENT_MISTAKE, lost, 0);
    add_event(&e[3], 23.0, VBSS_SESSION_EVENT_MISTAKE, lost, 1);
    const char *text = debrief(e, 4);
    assert_non_null(strstr(text, "That took 7.0 s in all."));
    assert_non_null(strstr(text, "<strong>7 points</strong>, from 10.0 s on"));
}

/* Four mistakes: the three that took longest are named, the longest first. */
static void the_three_largest_are_named_in_order(void **state)
{
    (void)state;
    const uint32_t kinds[] = {VBSS_SESSION_MISTAKE_TURNS_LOST, VBSS_SESSION_MISTAKE_SLACK,
                              VBSS_SESSION_MISTAKE_BIGHT, VBSS_SESSION_MISTAKE_TAIL_DROPPED};
    const double seconds[] = {3.0, 9.0, 2.0, 6.0};
    vbss_session_event e[8];
    for (size_t i = 0; i < 4; i++) {
        add_event(&e[2 * i], 20.0 * (double)i, VBSS_SESSION_EVENT_MISTAKE, kinds[i], 0);
        add_event(&e[2 * i + 1], 20.0 * (double)i + seconds[i], VBSS_SESSION_EVENT_MISTAKE,
                  kinds[i], 1);
    }
    const char *text = debrief(e, 8);
    const char *nine = strstr(text, "<strong>9 points</strong>"),
               *six = strstr(text, "<strong>6 points</strong>"),
               *three = strstr(text, "<strong>3 points</strong>");
    assert_non_null(nine);
    assert_non_null(six);
    assert_non_null(three);
    assert_true(nine < six && six < three);
    assert_null(strstr(text, "<strong>2 points</strong>"));
}

static void without_a_mistake_there_is_nothing_to_improve(void **state)
{
    (void)state;
    vbss_session_event e[1];
    add_event(&e[0], 60.0, VBSS_SESSION_EVENT_PHASE, VBSS_SESSION_PHASE_THROW_1, 0);
    assert_non_null(strstr(debrief(e, 1), "Nothing: no penalty"));
}

int test_debrief(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_missed_hole_costs_time_until_the_first_throw_begins),
        cmocka_unit_test(a_mistake_that_lasts_costs_time_until_the_end),
        cmocka_unit_test(a_mistake_that_is_mended_twice_costs_both_times),
        cmocka_unit_test(the_three_largest_are_named_in_order),
        cmocka_unit_test(without_a_mistake_there_is_nothing_to_improve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
