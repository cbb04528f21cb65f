/* Where rows stand in the system, and what they add there. */
#include "base/error.h"
#include "contact/contact.h"

static bool is_separator(const vbss_system *system, uint32_t b)
{
    return system->roles[b] == VBSS_ROLE_SEPARATOR;
}

vbss_result vbss_contact_register(const contact_set *set, vbss_system *system)
{
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_row *row = &set->rows[i];
        for (uint32_t p = 0; p < row->term_count; p++) {
            uint32_t a = row->terms[p].block;
            for (uint32_t q = p + 1; is_separator(system, a) && q < row->term_count; q++) {
                uint32_t b = row->terms[q].block;
                if (a != b && is_separator(system, b)) {
                    VBSS_TRY(vbss_system_couple_once(system, a, b));
                }
            }
        }
    }
    return VBSS_OK;
}

void vbss_contact_number_places(contact_set *set)
{
    set->place_count = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        uint32_t n = set->rows[i].term_count;
        set->rows[i].first_place = set->place_count;
        set->place_count += n * (n + 1);
    }
}

void vbss_contact_find_places(contact_set *set, const vbss_system *system)
{
    vbss_contact_number_places(set);
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_row *row = &set->rows[i];
        uint32_t n = row->term_count, *place = set->places + row->first_place;
        for (uint32_t p = 0; p < n; p++) {
            for (uint32_t q = p; q < n; q++) {
                vbss_system_pair_places(system, row->terms[p].block, row->terms[q].block,
                                        &place[p * n + q], &place[q * n + p]);
            }
            place[n * n + p] = vbss_system_rhs_place(system, row->terms[p].block);
        }
    }
}

/* How much u moves along a direction when the term's block changes; and what a force along it does to
 * the block. */
static vec3 map_to_block(const contact_term *term, vec3 direction)
{
    vec3 v = term->turns ? vec3_cross(term->arm, direction) : direction;
    return vec3_scale(v, term->weight);
}

/* The same of what its weight gains as the row slides on by a metre. */
static vec3 map_slope_to_block(const contact_term *term, vec3 direction)
{
    return term->turns ? vec3_cross(term->swing, direction) : vec3_scale(direction, term->slope);
}

static inline void add_product(block *to, vec3 left, vec3 right)
{
    lanes l = lanes_from(left);
    to->column[0] = lanes_add(to->column[0], lanes_scale(right.x, l));
    to->column[1] = lanes_add(to->column[1], lanes_scale(right.y, l));
    to->column[2] = lanes_add(to->column[2], lanes_scale(right.z, l));
}

static bool has_needle(const contact_row *row)
{
    for (uint32_t k = 0; k < row->term_count; k++) {
        if (row->terms[k].turns) {
            return true;
        }
    }
    return false;
}

/* What slides along a curve takes its force to other terms, and turns it: without that a bend that runs through would look
 * stiff, as its own tension turns too. And where the curve turns, or has slid on to where it has another direction n, the
 * force f across it does so as well, since it stays across: by -(f . dn) n, which drives along it, as far as it is not held
 * there. Of energy stiffness / 2 |point - hole|^2, least over all points of the curve, this is the second derivative, but for
 * terms that are as small beside it as point - hole is beside a segment. Two things are left out, with which searches found
 * their states less often (docs/stitch.md): that friction turns with n as nodes move, and all that turns f where a needle is
 * in it, as the bend at its swage may be sharper than a segment. */
static void add_sliding(const contact_row *row, const contact_tangent *t, const uint32_t *places,
                        vbss_system *system)
{
    const uint32_t n = row->term_count;
    const double along = vec3_dot(t->force, row->normal);
    const vec3 across = vec3_add_scaled(t->force, -along, row->normal);
    const vec3 turned = vec3_scale(row->turn, -along);
    const double slides = has_needle(row) ? 0.0 : 1.0 - t->stiffness[0] / row->stiffness;
    const double bent = slides * vec3_dot(across, row->turn);
    for (uint32_t p = 0; p < n; p++) {
        const contact_term *of = &row->terms[p];
        const vec3 here = map_to_block(of, row->normal);
        const vec3 left = vec3_sub(map_to_block(of, turned), map_slope_to_block(of, t->force));
        for (uint32_t q = 0; q < n; q++) {
            uint32_t place = places[p * n + q];
            if (place == VBSS_NO_PLACE) {
                continue;
            }
            block *to = &system->separator_blocks[place];
            const contact_term *by = &row->terms[q];
            const vec3 there = map_to_block(by, row->normal);
            add_product(to, left, there);
            add_product(
                to, here,
                vec3_add_scaled(vec3_scale(there, bent), -slides, map_slope_to_block(by, across)));
        }
    }
}

static void add_row(const contact_set *set, const contact_row *row, vbss_system *system)
{
    contact_tangent t;
    uint32_t n = row->term_count;
    const uint32_t *places = set->places + row->first_place;
    vec3 left[3][CONTACT_TERMS], right[3][CONTACT_TERMS];
    vbss_contact_linear_law(row, &t);
    if (t.count == 0) {
        return;
    }
    for (uint32_t p = 0; p < n; p++) {
        uint32_t rhs = places[n * n + p];
        for (uint32_t d = 0; d < t.count; d++) {
            left[d][p] = vec3_scale(map_to_block(&row->terms[p], t.left[d]), t.stiffness[d]);
            right[d][p] = map_to_block(&row->terms[p], t.right[d]);
        }
        if (rhs != VBSS_NO_PLACE) {
            vec3 *f = &system->separator_rhs[rhs];
            *f = vec3_add(*f, map_to_block(&row->terms[p], t.force));
        }
    }
    for (uint32_t p = 0; p < n; p++) {
        for (uint32_t q = 0; q < n; q++) {
            uint32_t place = places[p * n + q];
            for (uint32_t d = 0; place != VBSS_NO_PLACE && d < t.count; d++) {
                add_product(&system->separator_blocks[place], left[d][p], right[d][q]);
            }
        }
    }
    if (row->sleeve) {
        add_sliding(row, &t, places, system);
    }
}

void vbss_contact_assemble(const contact_set *set, vbss_system *system)
{
    for (uint32_t i = 0; i < set->count; i++) {
        add_row(set, &set->rows[i], system);
    }
}
