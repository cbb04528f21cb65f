/* One thread steps and publishes while another takes: each state is whole, in order, and the one that the scene had. */
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <time.h>

#include "rig.h"

#include "fixtures/tool_run.h"

/* Each state is published often, so that takes often meet a publication. Meshes are made of some. */
enum { COPIES = 20, STATES = TOOL_RUN_STEPS * COPIES, STATES_PER_MESH = 32 };

typedef struct relay {
    tool_run run;
    vbss_replica *replica;
    uint64_t wanted[STATES + 1]; /* by the number of the state: hash of the scene */
    atomic_bool is_ready;        /* the reader is */
    atomic_bool has_ended;       /* all are published */
    /* Of the reader. */
    long pause; /* between two takes, ns */
    uint64_t taken, missed, last, found[STATES + 1];
    bool is_ordered, is_drawn;
} relay;

static void publish(relay *e)
{
    while (!atomic_load(&e->is_ready)) {
        sched_yield();
    }
    for (uint64_t number = 1; number <= STATES; number++) {
        if (number % COPIES == 1) {
            expect_ok(tool_run_step(&e->run));
        }
        e->wanted[number] =
            number % COPIES == 1 ? rig_hash_scene(e->run.scene) : e->wanted[number - 1];
        expect_ok(vbss_replica_publish(e->replica, e->run.scene));
        if (number % ((uint64_t)10 * COPIES) == 0) {
            sched_yield(); /* the reader runs in between even where there is one core */
        }
    }
    atomic_store(&e->has_ended, true);
}

/* Assertions belong to the thread of the test, so what was found is kept. */
static void take(relay *e, vbss_visual *visual)
{
    vbss_replica_state state;
    if (vbss_replica_take(e->replica, &state, sizeof state) != VBSS_OK || state.is_new == 0) {
        return;
    }
    e->is_ordered = e->is_ordered && state.number > e->last && state.number <= STATES;
    e->last = state.number;
    e->missed = state.missed;
    e->taken++;
    if (e->is_ordered) {
        e->found[state.number] = rig_hash_replica(e->replica, &state);
    }
    if (e->taken % STATES_PER_MESH == 0) {
        e->is_drawn = e->is_drawn && vbss_visual_update(visual) == VBSS_OK;
    }
}

static void *read(void *user)
{
    relay *e = user;
    const struct timespec pause = {.tv_nsec = e->pause};
    vbss_context *context;
    vbss_visual *visual;
    e->is_ordered = true;
    e->is_drawn = vbss_context_create(NULL, &context) == VBSS_OK &&
                  vbss_visual_create(context, NULL, &visual) == VBSS_OK &&
                  vbss_visual_add_replica(visual, e->replica, NULL) == VBSS_OK;
    bool has_ended = !e->is_drawn;
    atomic_store(&e->is_ready, true);
    while (!has_ended) {
        has_ended = atomic_load(&e->has_ended); /* the last state comes before */
        take(e, visual);
        if (e->pause > 0) {
            nanosleep(&pause, NULL);
        }
    }
    vbss_context_destroy(context);
    return NULL;
}

static void relay_states(relay *e, long pause)
{
    harness_memory memory;
    pthread_t reader;
    vbss_context *context = harness_context(&memory);
    *e = (relay){.pause = pause};
    expect_ok(tool_run_create(context, VBSS_METHOD_IMPLICIT, &e->run));
    expect_ok(vbss_replica_create(e->run.scene, NULL, &e->replica));
    assert_int_equal(pthread_create(&reader, NULL, read, e), 0);
    publish(e);
    assert_int_equal(pthread_join(reader, NULL), 0);
    harness_context_end(context, &memory);
}

static void expect_whole(const relay *e)
{
    uint64_t found = 0;
    assert_true(e->is_ordered && e->is_drawn);
    assert_true(e->last == STATES); /* the newest one is never missed */
    for (uint64_t number = 1; number <= STATES; number++) {
        found += e->found[number] != 0;
        assert_true(e->found[number] == 0 || e->found[number] == e->wanted[number]);
    }
    assert_true(found == e->taken && e->taken + e->missed == STATES);
}

static void fast_reader_gets_whole_states_in_order(void **state)
{
    (void)state;
    static relay e;
    relay_states(&e, 0);
    expect_whole(&e);
}

static void slow_reader_misses_states_but_gets_whole_ones(void **state)
{
    (void)state;
    static relay e;
    relay_states(&e, 10000000);
    expect_whole(&e);
    assert_true(e.missed > 0);
}

int test_replica_threads(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(fast_reader_gets_whole_states_in_order),
        harness_test(slow_reader_misses_states_but_gets_whole_ones),
    };
    return cmocka_run_group_tests_name("replica.replica_threads", tests, NULL, NULL);
}
