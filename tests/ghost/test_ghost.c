/* Ghost hands: their file, where they are in the trainee's scene, and how they wait. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ghost/ghost.h"
#include "harness/harness.h"

#define FILE_NAME "test_ghost.bin"
#define SPEED 0.05 /* m/s, of the right tool of the track */
#define FRAME 0.016

enum { ROWS = 51, RIGHT_TOOL = 1 };

static const double quarter[4] = {0.70710678118654752, 0.0, 0.0, 0.70710678118654752};

/* In a phase of two seconds the right tool goes 100 mm along x, and the left one stays. */
static void make_track(ghost_track *t, int32_t phase_number)
{
    memset(t, 0, sizeof *t);
    for (int i = 0; i < ROWS; i++) {
        ghost_pose *row = ghost_track_add(t);
        assert_non_null(row);
        for (int side = 0; side < GHOST_SIDES; side++) {
            row[side] = (ghost_pose){.position = {-0.05, 0.01, 0.02},
                                     .orientation = {0.6, 0.0, -0.8, 0.0},
                                     .opening = 0.5,
                                     .kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
        }
        row[RIGHT_TOOL].position[0] = SPEED * GHOST_INTERVAL * i;
    }
    t->phases[phase_number] = (ghost_phase){
        .count = ROWS,
        .scene = {.marks = {{-4e-3, 0.0, 0.0}, {4e-3, 0.0, 0.0}}, .needle = {0.0, 0.0, 0.0, 1.0}}};
}

typedef struct rig {
    harness_memory memory;
    vbss_context *context;
    vbss_visual *visual;
    ghost_track track;
    ghost ghost;
    ghost_seen seen;
} rig;

static void begin(rig *r, int32_t phase_number)
{
    vbss_visual_config visual;
    vbss_grasper_config shapes[GHOST_SIDES];
    memset(r, 0, sizeof *r);
    make_track(&r->track, phase_number);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_visual_config_init(&visual, sizeof visual));
    expect_ok(vbss_visual_create(r->context, &visual, &r->visual));
    expect_ok(vbss_grasper_config_init(&shapes[0], sizeof shapes[0]));
    expect_ok(vbss_grasper_config_init(&shapes[1], sizeof shapes[1]));
    expect_ok(ghost_create(&r->ghost, &r->track, r->context, shapes, r->visual));
    r->seen.phase = phase_number;
    r->seen.scene = r->track.phases[phase_number].scene;
    memcpy(r->seen.tips[RIGHT_TOOL], r->track.rows[0][RIGHT_TOOL].position, sizeof r->seen.tips[0]);
}

static void end(rig *r)
{
    ghost_track_free(&r->track);
    harness_context_end(r->context, &r->memory);
}

static void run(rig *r, double seconds)
{
    for (int i = 0; FRAME * i < seconds; i++) {
        expect_ok(ghost_step(&r->ghost, &r->seen, FRAME));
    }
}

static uint32_t parts_shown(rig *r)
{
    vbss_visual_statistics shown;
    expect_ok(vbss_visual_update(r->visual));
    expect_ok(vbss_visual_get_statistics(r->visual, &shown, sizeof shown));
    return shown.parts;
}

/* ---- the file */

static void a_track_survives_its_file(void **state)
{
    (void)state;
    ghost_track t, again;
    char why[200];
    make_track(&t, VBSS_SESSION_PHASE_CUT);
    t.rows[7][0].kind = VBSS_GRASPER_KIND_SHEARS;
    assert_true(ghost_track_write(&t, FILE_NAME, why, sizeof why));
    assert_true(ghost_track_read(&again, FILE_NAME, why, sizeof why));
    assert_int_equal(again.count, ROWS);
    assert_int_equal(again.phases[VBSS_SESSION_PHASE_CUT].count, ROWS);
    assert_int_equal(again.phases[VBSS_SESSION_PHASE_THROW_1].count, 0);
    assert_memory_equal(&again.phases[VBSS_SESSION_PHASE_CUT].scene,
                        &t.phases[VBSS_SESSION_PHASE_CUT].scene, sizeof(ghost_scene));
    for (int i = 0; i < ROWS; i++) {
        for (int side = 0; side < GHOST_SIDES; side++) {
            const ghost_pose *a = &t.rows[i][side], *b = &again.rows[i][side];
            assert_int_equal(a->kind, b->kind);
            assert_true(fabs(a->opening - b->opening) <= 0.5 / 255.0);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(a->position[k] - b->position[k]) <= 0.5001e-5);
            }
            for (int k = 0; k < 4; k++) {
                assert_true(fabs(a->orientation[k] - b->orientation[k]) < 5e-5);
            }
        }
    }
    ghost_track_free(&t);
    ghost_track_free(&again);
}

static void damaged_files_are_refused(void **state)
{
    (void)state;
    static uint8_t bytes[1 << 16];
    ghost_track t, damaged;
    char why[200];
    make_track(&t, VBSS_SESSION_PHASE_CUT);
    assert_true(ghost_track_write(&t, FILE_NAME, why, sizeof why));
    FILE *file = fopen(FILE_NAME, "rb");
    assert_non_null(file);
    const size_t count = fread(bytes, 1, sizeof bytes, file);
    (void)fclose(file);
    assert_true(ghost_track_parse(&damaged, bytes, count));
    ghost_track_free(&damaged);
    assert_false(ghost_track_parse(&damaged, bytes, count - 1));
    assert_false(
        ghost_track_parse(&damaged, bytes, count - 32)); /* a phase has rows that are not there */
    assert_false(ghost_track_parse(&damaged, bytes, 0));
    assert_false(ghost_track_parse(&damaged, NULL, 0));
    bytes[count - 16 + 7] ^= 0x40; /* a quaternion of the last row */
    assert_false(ghost_track_parse(&damaged, bytes, count));
    bytes[count - 16 + 7] ^= 0x40;
    bytes[count - 1] = 3; /* the kind of a tool */
    assert_false(ghost_track_parse(&damaged, bytes, count));
    bytes[count - 1] = 1;
    bytes[0] = 'V';
    assert_false(ghost_track_parse(&damaged, bytes, count));
    assert_null(damaged.rows);
    assert_false(ghost_track_read(&damaged, "no/such/file", why, sizeof why));
    assert_non_null(strstr(why, "no/such/file"));
    ghost_track_free(&t);
}

/* ---- pace */

static void a_ghost_leads_and_waits(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_THROW_1);
    expect_ok(ghost_step(&r.ghost, &r.seen, FRAME));
    expect_ok(ghost_step(&r.ghost, &r.seen, 1.5)); /* a frame that took long */
    const double ahead = r.ghost.poses[RIGHT_TOOL].position[0];
    assert_true(ahead > 0.015 && ahead < 0.015 + SPEED * 2.0 * GHOST_INTERVAL);
    run(&r, 0.4);
    assert_true(r.ghost.poses[RIGHT_TOOL].position[0] == ahead);
    r.seen.tips[RIGHT_TOOL][0] = 0.01; /* the trainee follows by 10 mm */
    run(&r, 1.5);
    assert_true(fabs(r.ghost.poses[RIGHT_TOOL].position[0] - ahead - 0.01) <
                SPEED * 2.0 * GHOST_INTERVAL);
    end(&r);
}

static void it_keeps_its_speed_beside_the_trainee(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_THROW_1);
    for (int i = 0; i <= 62; i++) { /* the first step begins the phase */
        expect_ok(ghost_step(&r.ghost, &r.seen, FRAME));
        r.seen.tips[RIGHT_TOOL][0] = r.ghost.poses[RIGHT_TOOL].position[0];
        memcpy(&r.seen.tips[RIGHT_TOOL][1], &r.ghost.poses[RIGHT_TOOL].position[1],
               2 * sizeof(double));
    }
    assert_true(fabs(r.ghost.poses[RIGHT_TOOL].position[0] - SPEED * 62.0 * FRAME) < 1e-9);
    run(&r, 5.0);
    assert_true(r.ghost.poses[RIGHT_TOOL].position[0] <= SPEED * GHOST_INTERVAL * (ROWS - 1));
    end(&r);
}

static void it_goes_to_where_the_trainee_is(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_THROW_1);
    run(&r, 1.0);
    for (int i = 0; i < 3; i++) { /* on: the trainee is on its path, and ahead */
        r.seen.tips[RIGHT_TOOL][i] = r.ghost.poses[RIGHT_TOOL].position[i];
    }
    r.seen.tips[RIGHT_TOOL][0] = 0.08;
    run(&r, 2.5);
    assert_true(r.ghost.poses[RIGHT_TOOL].position[0] > 0.08);
    r.seen.tips[RIGHT_TOOL][0] = 0.03; /* and back */
    run(&r, 4.5);
    assert_true(fabs(r.ghost.poses[RIGHT_TOOL].position[0] - 0.03) < 0.02);
    end(&r);
}

/* ---- place */

static void it_takes_the_needle_where_it_lies(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_LOADING);
    r.seen.scene.needle[0] = 0.01; /* shifted, and turned by a quarter */
    r.seen.scene.needle[1] = 0.02;
    r.seen.scene.needle[2] = -0.003;
    memcpy(r.seen.scene.needle + 3, quarter, sizeof quarter);
    run(&r, FRAME);
    const ghost_pose *left = &r.ghost.poses[0];
    const double wanted[3] = {0.01 - 0.01, 0.02 - 0.05, 0.02 - 0.003};
    const double c = quarter[0]; /* quarter times 0.6 - 0.8 j */
    const double turned[4] = {0.6 * c, 0.8 * c, -0.8 * c, 0.6 * c};
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(left->position[i] - wanted[i]) < 1e-12);
    }
    for (int i = 0; i < 4; i++) {
        assert_true(fabs(left->orientation[i] - turned[i]) < 1e-12);
    }
    end(&r);
}

static void it_works_at_the_marks(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_THROW_2);
    memcpy(r.seen.scene.needle + 3, quarter, sizeof quarter); /* that does not matter here */
    for (int side = 0; side < 2; side++) {                    /* marks along -y, 5 mm higher */
        r.seen.scene.marks[side][0] = 0.0;
        r.seen.scene.marks[side][1] =
            -r.track.phases[VBSS_SESSION_PHASE_THROW_2].scene.marks[side][0];
        r.seen.scene.marks[side][2] = 5e-3;
    }
    run(&r, FRAME);
    const double wanted[3] = {0.01, 0.05, 0.025};
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(r.ghost.poses[0].position[i] - wanted[i]) < 1e-12);
    }
    end(&r);
}

/* ---- shown */

static void only_phases_of_the_track_are_shown(void **state)
{
    (void)state;
    rig r;
    begin(&r, VBSS_SESSION_PHASE_CUT);
    r.track.rows[0][0].kind = VBSS_GRASPER_KIND_SHEARS;
    run(&r, FRAME);
    assert_int_equal(parts_shown(&r), 2);
    vbss_grasper_state tool;
    expect_ok(vbss_grasper_get_state(r.ghost.graspers[0], &tool, sizeof tool));
    assert_int_equal(tool.kind, VBSS_GRASPER_KIND_SHEARS);
    r.seen.phase = VBSS_SESSION_PHASE_FAILED;
    run(&r, FRAME);
    assert_int_equal(parts_shown(&r), 0);
    r.seen.phase = VBSS_SESSION_PHASE_THROW_1;
    run(&r, FRAME);
    assert_int_equal(parts_shown(&r), 0);
    for (int i = 0; i < 20; i++) { /* on and off as often as one likes */
        r.seen.phase = i % 2 == 0 ? VBSS_SESSION_PHASE_CUT : VBSS_SESSION_PHASE_IDLE;
        run(&r, FRAME);
        assert_int_equal(parts_shown(&r), i % 2 == 0 ? 2 : 0);
    }
    end(&r);
}

int test_ghost(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_track_survives_its_file),
        cmocka_unit_test(damaged_files_are_refused),
        cmocka_unit_test(a_ghost_leads_and_waits),
        cmocka_unit_test(it_keeps_its_speed_beside_the_trainee),
        cmocka_unit_test(it_goes_to_where_the_trainee_is),
        cmocka_unit_test(it_takes_the_needle_where_it_lies),
        cmocka_unit_test(it_works_at_the_marks),
        cmocka_unit_test(only_phases_of_the_track_are_shown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
