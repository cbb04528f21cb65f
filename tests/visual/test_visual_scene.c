/* A scene that is drawn while it is stepped: pieces, tools that change, holes, nothing allocated, nothing changed. */
#include "fixture.h"

#include "fixtures/stitch_scenes.h"
#include "fixtures/tool_run.h"

static uint32_t parts_of_kind(const drawn *d, vbss_visual_kind kind)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < d->part_count; i++) {
        count += d->parts[i].kind == (uint32_t)kind;
    }
    return count;
}

static uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

/* Graspers pull at a thread, one becomes shears and cuts it: the piece is drawn from then on. */
static void pieces_and_exchanged_tools_are_drawn(void **state)
{
    (void)state;
    fixture f;
    tool_run run;
    vbss_context_statistics before, after;
    begin(&f);
    make(&f);
    expect_ok(tool_run_create(f.context, VBSS_METHOD_IMPLICIT, &run));
    expect_ok(vbss_visual_add_scene(f.visual, run.scene, NULL));
    drawn d = draw(&f);
    assert_int_equal(parts_of_kind(&d, VBSS_VISUAL_KIND_THREAD), 1);
    assert_int_equal(parts_of_kind(&d, VBSS_VISUAL_KIND_DRIVER), 2);
    for (int i = 0; i < TOOL_RUN_STEPS; i++) {
        expect_ok(tool_run_step(&run));
        uint64_t hash = hash_of(run.scene);
        expect_ok(vbss_context_get_statistics(f.context, &before, sizeof before));
        d = draw(&f);
        expect_ok(vbss_context_get_statistics(f.context, &after, sizeof after));
        assert_true(after.allocation_count == before.allocation_count);
        assert_true(hash_of(run.scene) == hash); /* a picture changes nothing */
        for (uint32_t k = 0; k < d.part_count && i % 10 == 0; k++) {
            if (d.parts[k].kind != VBSS_VISUAL_KIND_FLOOR) {
                expect_sound(&d, &d.parts[k]);
            }
        }
    }
    assert_int_equal(parts_of_kind(&d, VBSS_VISUAL_KIND_THREAD), 2);
    assert_int_equal(parts_of_kind(&d, VBSS_VISUAL_KIND_DRIVER), 1);
    assert_int_equal(parts_of_kind(&d, VBSS_VISUAL_KIND_SHEARS), 1);
    expect_ok(vbss_scene_destroy(run.scene));
    d = draw(&f);
    assert_int_equal(d.part_count, 0);
    end(&f);
}

/* Spots of holes are where the scene says that they are, in the material of the wall around them. */
static void holes_are_decals_of_their_drain(void **state)
{
    (void)state;
    static stitch_scene_options options;
    static stitch_scene stitch;
    fixture f;
    begin(&f);
    make(&f);
    expect_ok(stitch_scene_init(&options));
    options.crossings = 1;
    expect_ok(stitch_scene_create(f.context, &options, &stitch));
    expect_ok(vbss_visual_add_scene(f.visual, stitch.scene, NULL));
    const drawn d = draw(&f);
    uint32_t holes = 0;
    for (uint32_t i = 0; i < d.decal_count; i++) {
        const visual_decal *s = &d.decals[i];
        const visual_part *part = &d.parts[(uint32_t)s->part];
        assert_int_equal(part->kind, VBSS_VISUAL_KIND_DRAIN);
        if ((double)s->kind < VBSS_VISUAL_SPOT_HOLE - 0.5) {
            continue;
        }
        vbss_scene_hole hole;
        expect_ok(vbss_scene_get_hole(stitch.scene, holes++, &hole, sizeof hole));
        vec3 at = vec3_make((double)s->material[0], (double)s->material[1], (double)s->material[2]);
        assert_true(vec3_distance(at, vec3_load(hole.rest_position)) < 1e-9);
        expect_near(options.thread.radius, (double)s->radius, 1e-9);
        /* The vertex whose material is nearest is drawn near the hole. */
        double nearest = 1.0, away = 1.0;
        for (uint32_t k = 0; k < part->vertex_count; k++) {
            double far = vec3_distance(material_of(&d, part->first_vertex + k), at);
            if (far < nearest) {
                nearest = far;
                away = vec3_distance(position_of(&d, part->first_vertex + k),
                                     vec3_load(hole.position));
            }
        }
        assert_true(nearest < 0.5e-3);
        assert_true(away < 1.1e-3);
    }
    assert_int_equal(holes, 2);
    end(&f);
}

/* The same scene twice gives the same bits. */
static void pictures_are_bit_equal(void **state)
{
    (void)state;
    uint64_t hashes[2];
    for (int k = 0; k < 2; k++) {
        fixture f;
        tool_run run;
        vbss_hash hash;
        begin(&f);
        make(&f);
        expect_ok(tool_run_create(f.context, VBSS_METHOD_IMPLICIT, &run));
        expect_ok(vbss_visual_add_scene(f.visual, run.scene, NULL));
        vbss_hash_begin(&hash);
        for (int i = 0; i < 60; i++) {
            expect_ok(tool_run_step(&run));
            const drawn d = draw(&f);
            vbss_hash_add(&hash, d.vertices, d.vertex_count * sizeof *d.vertices);
            vbss_hash_add(&hash, d.triangles, d.triangle_count * sizeof *d.triangles);
        }
        hashes[k] = vbss_hash_end(&hash);
        end(&f);
    }
    assert_true(hashes[0] == hashes[1]);
}

int test_visual_scene(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(pieces_and_exchanged_tools_are_drawn),
        harness_test(holes_are_decals_of_their_drain),
        harness_test(pictures_are_bit_equal),
    };
    return cmocka_run_group_tests_name("visual.visual_scene", tests, NULL, NULL);
}
