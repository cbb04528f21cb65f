/* What a collision object shows of itself. */
#include "collision/shapes_model.h"
#include "collision/shapes_object.h"

static void view_dimensions(void **state)
{
    (void)state;
    static const struct {
        vbss_view_type type;
        uint32_t components;
    } wanted[] = {{VBSS_VIEW_TYPE_U32, 5}, {VBSS_VIEW_TYPE_U32, 1}, {VBSS_VIEW_TYPE_F64, 1},
                  {VBSS_VIEW_TYPE_F64, 3}, {VBSS_VIEW_TYPE_F64, 4}, {VBSS_VIEW_TYPE_U32, 1},
                  {VBSS_VIEW_TYPE_F64, 1}};
    object_fixture f;
    object_begin(&f);
    vbss_collision_statistics s = shapes_statistics(f.collision);
    assert_true(s.impacts > 0 && s.impacts < s.candidates);
    for (vbss_collision_field field = 0; field < 7; field++) {
        vbss_view view = shapes_view(f.collision, field);
        assert_int_equal(view.struct_size, sizeof view);
        assert_int_equal(view.type, wanted[field].type);
        assert_int_equal(view.components, wanted[field].components);
        assert_true(view.stride_bytes >=
                    wanted[field].components * (view.type == VBSS_VIEW_TYPE_F64 ? 8u : 4u));
        assert_int_equal(view.count,
                         field == VBSS_COLLISION_VIEW_CANDIDATES ? s.candidates : s.impacts);
        assert_non_null(view.data);
    }
    const vbss_collision_field none[] = {-1, 7, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 4; i++) {
        vbss_view view;
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_collision_get_view(f.collision, none[i], &view, sizeof view));
    }
    object_end(&f);
}

static void generation_changes_with_every_edit(void **state)
{
    (void)state;
    object_fixture f;
    uint8_t bytes[4096];
    uint64_t written;
    object_begin(&f);
    expect_ok(vbss_collision_save(f.collision, bytes, sizeof bytes, &written));
    uint64_t before = shapes_view(f.collision, VBSS_COLLISION_VIEW_TIMES).generation;
    expect_ok(vbss_collision_restore(f.collision, bytes, written));
    const int edits = OBJECT_EDITS - 3; /* tests change the counters alone */
    for (int i = 0; i <= edits; i++) {
        for (int k = OBJECT_EDITS; k < OBJECT_CALLS; k++) {
            expect_ok(object_calls[k](f.collision)); /* looking changes nothing */
        }
        uint64_t now = shapes_view(f.collision, VBSS_COLLISION_VIEW_CANDIDATES).generation;
        assert_true(now != before);
        assert_true(shapes_view(f.collision, VBSS_COLLISION_VIEW_TIMES).generation == now);
        expect_ok(i < edits ? object_calls[i](f.collision) : VBSS_OK);
        before = now;
    }
    object_end(&f);
}

int test_object_views(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(view_dimensions),
        cmocka_unit_test(generation_changes_with_every_edit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
