/* What slides along a curve: what rows add to the system is the slope of the forces on its blocks, found anew on the shifted
 * curve. */
#include "few_blocks.h"
#include "suture/suture.h"

/* Nodes of a thread, then the point of the wall. */
enum { NODES = 6, WALL = NODES };

typedef struct sliding {
    vec3 x[NODES], wall;
    double rest[NODES - 1];
    thread_object thread;
    double from; /* arc length from which on it has slid */
} sliding;

static suture_place place_of(const sliding *s, vec3 shift)
{
    const suture_line line = {.thread = &s->thread, .x = s->x};
    return vbss_suture_nearest(&line, s->from, vec3_sub(s->wall, shift));
}

/* As a hole lays it; the thread has been shifted against the wall. */
static void lay(const sliding *s, vec3 shift, contact_row *row)
{
    const suture_place now = place_of(s, shift);
    row->normal = now.tangent;
    row->turn = now.turn;
    row->slid = vec3_sub(now.point, vec3_sub(s->wall, shift));
    row->slid = vec3_add_scaled(row->slid, now.arc - s->from, now.tangent);
    row->term_count = 0;
    for (uint32_t i = 0; i < 3; i++) {
        row->terms[row->term_count++] = (contact_term){
            .block = now.first + i, .weight = now.weights[i], .slope = now.slopes[i]};
    }
    row->terms[row->term_count++] = (contact_term){.block = WALL, .weight = -1.0};
}

static void forces(const sliding *s, const contact_row *like, vec3 shift, vec3 force[WALL + 1])
{
    contact_row row = *like;
    lay(s, shift, &row);
    vec3 f = vbss_contact_force(&row, vec3_zero());
    for (uint32_t i = 0; i <= WALL; i++) {
        force[i] = vec3_zero();
    }
    for (uint32_t p = 0; p < row.term_count; p++) {
        force[row.terms[p].block] = vec3_scale(f, row.terms[p].weight);
    }
}

static void draw(harness_source *source, sliding *s)
{
    *s = (sliding){.thread = {.node_count = NODES}};
    s->thread.rest = s->rest;
    for (int i = 1; i < NODES; i++) {
        s->rest[i - 1] = harness_draw_real(source, 0.7e-3, 1.3e-3);
        vec3 way = vec3_add(vec3_make(1.0, 0.3 * i, 0.0), harness_draw_vec3(source, -0.3, 0.3));
        s->x[i] = vec3_add_scaled(s->x[i - 1], s->rest[i - 1], vec3_unit_or(way, way));
    }
}

/* A parabola is shorter than the corner that it rounds, which the arc length is of: here the thread is stretched so that
 * both grow alike at the place. */
static void stretch(sliding *s)
{
    const double step = 1e-7;
    const suture_place now = place_of(s, vec3_zero());
    const vec3 shift = vec3_scale(now.tangent, step), wall = s->wall;
    s->wall = now.point;
    double slid = place_of(s, shift).arc - place_of(s, vec3_neg(shift)).arc;
    for (int i = 0; i + 1 < NODES; i++) {
        s->rest[i] *= 2.0 * step / slid;
    }
    s->wall = wall;
}

/* A row with the state that it has there. */
static contact_row draw_row(harness_source *source, sliding *s)
{
    contact_row row = {.stiffness = 2e5, .bilateral = true, .sleeve = true, .beyond = 50.0};
    const suture_line line = {.thread = &s->thread, .x = s->x};
    s->from = harness_draw_real(source, 1.5e-3, 3.5e-3);
    s->wall = vec3_lerp(s->x[1], s->x[4], harness_draw_real(source, 0.2, 0.8));
    s->wall = vbss_suture_nearest(&line, s->from, s->wall).point;
    /* Stiff: nearer to the curve than that its curvature would matter. */
    s->wall = vec3_add(s->wall, harness_draw_vec3(source, -2e-6, 2e-6));
    stretch(s);
    row.least = harness_draw_real(source, 0.1, 1.0);
    row.grip[0] = harness_draw_real(source, 0.1, 1.0);
    row.grip[1] = harness_draw_real(source, 0.1, 1.0);
    s->from = place_of(s, vec3_zero()).arc + harness_draw_real(source, -1e-5, 1e-5);
    lay(s, vec3_zero(), &row);
    (void)vbss_contact_next_state(&row, vec3_zero(), &row.is);
    return row;
}

static void begin_system(few_blocks *f, const contact_row *row)
{
    few_begin(f, WALL + 1);
    contact_row *added = few_plane(f, 0, 0, row->normal);
    const contact_key key = added->key;
    *added = *row;
    added->key = key;
    few_register(f);
    vbss_system_clear(f->system);
    for (uint32_t i = 0; i <= WALL; i++) {
        block_set(&f->system->diagonal[i], mat3_zero());
        f->system->rhs[i] = vec3_zero();
    }
    assert_true(vbss_system_condense(f->system));
    vbss_system_take_separators(f->system);
    vbss_contact_assemble(f->set, f->system);
}

static mat3 block_of(const few_blocks *f, uint32_t row, uint32_t column)
{
    uint32_t place = vbss_system_place(f->system, row, column);
    return place == VBSS_NO_PLACE ? mat3_zero() : block_mat3(&f->system->separator_blocks[place]);
}

/* What turns out of the force across into that along is left out of a row that slips: with it the ways of a rope over
 * posts come out wrong by a percent (docs/stitch.md). */
static vec3 compared(const contact_row *row, vec3 slope)
{
    return row->is.state == CONTACT_SLIP ? across(slope, row->normal) : slope;
}

static void any_row_that_slides_has_its_slope(harness_source *source, void *user)
{
    const double step = 1e-9, most = 3.0;
    int *seen = user;
    sliding s;
    few_blocks f;
    vec3 now[WALL + 1], on[WALL + 1], back[WALL + 1];
    draw(source, &s);
    const contact_row row = draw_row(source, &s);
    if (vec3_norm(row.is.rubbing) < 0.05) {
        return; /* nothing across has a direction */
    }
    begin_system(&f, &row);
    forces(&s, &row, vec3_zero(), now);
    for (uint32_t p = 0; p <= WALL; p++) {
        vec3 rhs = f.system->separator_rhs[vbss_system_rhs_place(f.system, p)];
        expect_near(0.0, vec3_distance(now[p], rhs), 1e-12);
    }
    for (int i = 0; i < 3; i++) {
        const vec3 way = vec3_make(i == 0, i == 1, i == 2);
        forces(&s, &row, vec3_scale(way, step), on);
        forces(&s, &row, vec3_scale(way, -step), back);
        for (uint32_t p = 0; p <= WALL; p++) {
            vec3 slope = vec3_scale(vec3_sub(back[p], on[p]), 0.5 / step), all = vec3_zero();
            for (uint32_t q = 0; q < row.term_count; q++) {
                vec3 part = mat3_mul_vec3(block_of(&f, p, row.terms[q].block), way);
                /* A node moves the place by its weight. */
                vec3 share = vec3_scale(slope, row.terms[q].weight);
                expect_near(0.0, vec3_norm(compared(&row, vec3_sub(part, share))), most);
                all = q + 1 < row.term_count ? vec3_add(all, part) : all;
            }
            expect_near(0.0, vec3_norm(compared(&row, vec3_sub(all, slope))), most);
        }
    }
    seen[row.is.state == CONTACT_SLIP]++;
    few_end(&f);
}

static void what_it_adds_is_the_slope_of_the_forces(void **state)
{
    (void)state;
    int seen[2] = {0};
    harness_property("slope", 300, any_row_that_slides_has_its_slope, seen);
    assert_true(seen[0] > 30 && seen[1] > 30);
}

int test_sliding(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(what_it_adds_is_the_slope_of_the_forces),
    };
    return cmocka_run_group_tests_name("contact.sliding", tests, NULL, NULL);
}
