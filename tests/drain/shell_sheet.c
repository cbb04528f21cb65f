#include "drain/shell_sheet.h"

#include "base/elementary.h"

typedef struct random_sheet {
    harness_source *source;
    double columns, rows, turn;
} random_sheet;

static vec3 sheet_at(double u, double v, const void *user)
{
    const random_sheet *s = user;
    vec3 off = harness_draw_vec3(s->source, -0.2, 0.2);
    double angle = s->turn * (u - 0.5), radius = s->columns / s->turn;
    vec3 on = vec3_make(radius * vbss_sin(angle), s->rows * v, radius * vbss_cos(angle));
    return vec3_add(on, off);
}

void shell_sheet_draw(harness_source *source, shell_rig *r, vbss_shell_input *in)
{
    random_sheet s = {.source = source};
    s.columns = 1.0 + harness_draw_below(source, 4);
    s.rows = 1.0 + harness_draw_below(source, 3);
    s.turn = harness_draw_real(source, -0.6, 0.6) * s.columns + 1e-3;
    bool flipped = harness_draw_below(source, 2) == 0;
    shell_rig_mesh(r, (uint32_t)s.columns, (uint32_t)s.rows, false, flipped, sheet_at, &s);
    *in = shell_rig_input(r);
    in->poisson = harness_draw_real(source, 0.0, 0.5);
    in->thickness = harness_draw_real(source, 0.05, 0.3);
    in->moment_free_edges = harness_draw_below(source, 2) == 0;
    for (uint32_t i = 0; i < r->triangle_count; i++) {
        r->widths[i] = harness_draw_below(source, 2) == 0 ? 0.0 : 0.5;
    }
}

void shell_sheet_start(harness_source *source, shell_rig *r)
{
    vbss_shell_input in;
    shell_sheet_draw(source, r, &in);
    shell_rig_start(r, &in);
}

void shell_sheet_deform(harness_source *source, shell_rig *r, double by)
{
    quat turn = harness_draw_unit_quat(source);
    vec3 away = harness_draw_vec3(source, -1.0, 1.0);
    for (uint32_t i = 0; i < r->node_count; i++) {
        vec3 off = harness_draw_vec3(source, -by, by);
        r->x[i] = vec3_add(quat_rotate(turn, vec3_add(r->rest[i], off)), away);
    }
}
