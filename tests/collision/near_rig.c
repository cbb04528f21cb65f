#include "collision/near_rig.h"

void near_begin(near_rig *f)
{
    f->context = harness_context(&f->memory);
    model_begin(&f->m);
    f->m.config.pair_capacity = 200000;
}

void near_make(near_rig *f)
{
    expect_ok(vbss_collision_create(f->context, &f->m.config, &f->collision));
    expect_ok(vbss_collision_open(f->collision, &f->object));
    model_add_to(&f->m, f->collision);
}

void near_end(near_rig *f)
{
    model_end(&f->m);
    harness_context_end(f->context, &f->memory);
}

uint64_t near_hash(const near_rig *f)
{
    uint64_t hash;
    expect_ok(vbss_collision_get_hash(f->collision, &hash));
    return hash;
}

void near_leave_out(const near_rig *f, uint32_t name, const vec3 *at, double distance)
{
    expect_ok(vbss_collision_exclude_near(f->object, name, at, distance));
}

model_shape *near_add_slit_sheet(near_rig *f)
{
    model_shape *s = model_slit_sheet(&f->m, NEAR_COLUMNS, NEAR_ROWS, NEAR_SLIT, 0.25);
    for (uint32_t i = 0; i < s->node_count; i++) {
        uint32_t node = i < NEAR_COLUMNS * NEAR_ROWS
                            ? i
                            : i - NEAR_COLUMNS * NEAR_ROWS + NEAR_SLIT * NEAR_COLUMNS + 1;
        uint32_t row = node / NEAR_COLUMNS;
        s->start[i] = s->end[i] = vec3_make(node % NEAR_COLUMNS, row, 0.0);
    }
    return s;
}
