#include "throw/senses.h"

#include <string.h>

#define TOUCH 0.4e-3
#define KNOT_SIZE 4e-3 /* that of a tight one is within */
enum { FARTHER = 15 }; /* nodes */
#define SMOOTH 0.1     /* share of a new tension in each step */

vbss_result senses_create(senses *s, throw_rig *st, hand *w, hand *c)
{
    vbss_knot_detector_config config;
    memset(s, 0, sizeof *s);
    s->rig = st;
    s->w = w;
    s->c = c;
    s->nodes = st->nodes;
    s->tail_root = st->marks[0];
    s->limb_root = st->marks[1];
    TRY(vbss_knot_detector_config_init(&config, sizeof config));
    TRY(vbss_knot_detector_create(st->context, &config, &s->detector));
    return vbss_knot_detector_create(st->context, &config, &s->arbiter);
}

/* ---- where the limb touches W */

static double distance(vec x, vec a, vec b, double *along)
{
    vec edge = v_sub(b, a);
    double t = clamp(v_dot(v_sub(x, a), edge) / v_dot(edge, edge), 0.0, 1.0);
    *along = t * v_length(edge);
    return v_distance(x, v_along(a, t, edge));
}

static bool touches(const senses *s, vec x, double *from_tip)
{
    const vbss_grasper_config *c = &s->w->shape;
    double along;
    bool any = false;
    for (int i = 0; i < 4; i++) {
        const double *part = s->parts + (size_t)7 * (size_t)i;
        any = any || distance(x, seen_scene(s->w, v_load(part)), seen_scene(s->w, v_load(part + 3)),
                              &along) < part[6] + THREAD_RADIUS + TOUCH;
    }
    double reach = hand_reach(s->w), from = v_dot(v_sub(x, s->tool_w.tip), s->tool_w.handle);
    *from_tip = clamp(from, 0.0, reach + c->shaft_length);
    return any;
}

/* What hangs from C's jaws does not count, unless it is the tail that they hold. */
static uint32_t limb_end(const senses *s)
{
    return senses_holds(s, s->c) && s->c->node > s->limb_root ? s->c->node : s->nodes;
}

static void find_contacts(senses *s)
{
    uint32_t end = limb_end(s) - 3;
    s->first = s->last = 0;
    for (uint32_t i = s->limb_root; i < end; i++) {
        double at;
        if (touches(s, s->x[i], &at)) {
            s->last = i;
            s->last_s = at;
            if (s->first == 0) {
                s->first = i;
                s->first_s = at;
            }
        }
    }
}

/* Both detectors begin anew with what is left of the thread. */
static vbss_result follow_cuts(senses *s)
{
    uint32_t shift = s->rig->shift - s->shift;
    if (s->nodes == s->rig->nodes) {
        return VBSS_OK;
    }
    s->nodes = s->rig->nodes;
    s->shift = s->rig->shift;
    s->tail_root -=
        shift < s->tail_root ? shift : s->tail_root; /* cut inside the knot: none left */
    s->limb_root -= shift;
    TRY(vbss_knot_detector_reset(s->detector));
    return vbss_knot_detector_reset(s->arbiter);
}

static double drawn(vec pull, vec jaws, vec root)
{
    return v_dot(pull, v_unit(v_sub(root, jaws)));
}

void senses_feel(senses *s)
{
    vec w = s->w->pull, c = s->c->pull;
    s->tension_w += SMOOTH * (v_length(w) - s->tension_w);
    s->tension_c += SMOOTH * (v_length(c) - s->tension_c);
    s->draws_w += SMOOTH * (drawn(w, s->tool_w.tip, s->x[s->tail_root]) - s->draws_w);
    s->draws_c += SMOOTH * (drawn(c, s->held_c, s->x[s->limb_root]) - s->draws_c);
}

vbss_result senses_observe(senses *s)
{
    vbss_view view;
    TRY(follow_cuts(s));
    const vec *x = throw_rig_nodes(s->rig);
    for (uint32_t i = 0; i < s->nodes; i++) {
        s->x[i] = seen_scene(s->w, x[i]);
    }
    TRY(hand_observe(s->w, &s->tool_w));
    TRY(hand_observe(s->c, &s->tool_c));
    TRY(vbss_grasper_get_view(s->w->grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
    s->parts = view.data;
    s->held_c = v_along(s->tool_c.tip, GRASP_BEHIND, s->tool_c.handle);
    if (s->c->holds && !senses_holds(s, s->c)) { /* the needle */
        s->c->node = s->nodes - 1;
        s->held_c = s->x[s->c->node];
    }
    senses_feel(s);
    find_contacts(s);
    return VBSS_OK;
}

vec senses_drain(const senses *s)
{
    const uint32_t *marks = s->rig->marks;
    vec middle = v_scale(0.5, v_add(s->x[marks[0]], s->x[marks[1]]));
    return v3(middle.x, middle.y, 0.0);
}

vec senses_tip_holding_up(const senses *s, vec direction, double share)
{
    double length = senses_length(s, s->limb_root, s->c->node);
    vec jaws = v_along(s->x[s->limb_root], share * length, v_unit(direction));
    if (s->c->holds && !senses_holds(s, s->c)) { /* by the needle */
        return v_sub(jaws, v_sub(s->held_c, s->tool_c.tip));
    }
    return v_along(jaws, -GRASP_BEHIND, s->tool_c.handle);
}

/* ---- what the detector says */

static vbss_knot_tool as_tool(const senses *s, const hand *h, const hand_pose *pose)
{
    vbss_knot_tool t = {.point_count = 3};
    v_store(t.axis[0], seen_scene(h, pose->trocar));
    v_store(t.axis[1], seen_scene(h, pose->bend));
    v_store(t.axis[2], seen_scene(h, pose->tip));
    t.radius[0] = h->shape.shaft_radius;
    t.radius[1] = h->shape.neck_radius;
    bool held = senses_holds(s, h);
    t.held = held ? VBSS_KNOT_HELD_THREAD : VBSS_KNOT_HELD_NOTHING;
    t.held_place =
        held ? larger(h->place, 0.0) : 0.0; /* at the end it is 0 but for what rounding leaves */
    if (h->holds && !held && h->node == s->nodes - 1) {
        t.held = VBSS_KNOT_HELD_NEEDLE;
    }
    return t;
}

static vbss_result show(const senses *s, vbss_knot_tool tools[2], vbss_knot_input *in)
{
    const vec *x = throw_rig_nodes(s->rig);
    TRY(vbss_knot_input_init(in, sizeof *in));
    in->points = &x[0].x;
    in->point_count = s->nodes;
    tools[0] = as_tool(s, s->w, &s->tool_w);
    tools[1] = as_tool(s, s->c, &s->tool_c);
    in->tools = tools;
    in->tool_count = 2;
    in->hole_count = 2;
    for (int i = 0; i < 2; i++) {
        v_store(in->holes[i], x[s->rig->marks[i]]);
        in->hole_places[i] = s->rig->marks[i];
    }
    in->away[2] = -1.0;
    return VBSS_OK;
}

vbss_result senses_wind(senses *s)
{
    vbss_knot_tool tools[2];
    vbss_knot_input in;
    vbss_knot_winding winding;
    TRY(show(s, tools, &in));
    TRY(vbss_knot_detector_step(s->detector, &in));
    TRY(vbss_knot_detector_get_winding(s->detector, 0, &winding, sizeof winding));
    s->turns = s->w->side * mirror_sign(s->rig->mirrored) * winding.turns;
    return VBSS_OK;
}

vbss_result senses_judge(senses *s, bool with_tools, senses_knot *k)
{
    vbss_knot_detector *d = with_tools ? s->detector : s->arbiter;
    vbss_knot_tool tools[2];
    vbss_knot_input in;
    TRY(show(s, tools, &in));
    in.tool_count = with_tools ? 2 : 0;
    TRY(vbss_knot_detector_judge(d, &in));
    TRY(vbss_knot_detector_get_state(d, &k->state, sizeof k->state));
    k->handedness = 0;
    k->slip = 0.0;
    if (k->state.throw_count > 0) {
        vbss_knot_throw last;
        TRY(vbss_knot_detector_get_throw(d, k->state.throw_count - 1, &last, sizeof last));
        k->handedness = last.handedness;
        k->slip = last.slip;
    }
    return vbss_knot_detector_get_notation(d, k->notation, sizeof k->notation);
}

/* ---- where the knot is */

static bool is_of_knot(const senses *s, const uint32_t *contact, uint32_t end)
{
    return contact[0] == VBSS_SCENE_CONTACT_SEGMENTS && contact[1] == s->rig->thread_body &&
           contact[3] == s->rig->thread_body && throw_rig_segment(s->rig, contact[2]) < end &&
           throw_rig_segment(s->rig, contact[4]) < end;
}

static const uint32_t *contact_at(const vbss_view *v, uint64_t i)
{
    return (const uint32_t *)((const char *)v->data + i * v->stride_bytes);
}

static vec point_at(const vbss_view *v, uint64_t i)
{
    return v_load((const double *)((const char *)v->data + i * v->stride_bytes));
}

vbss_result senses_find_knot(senses *s)
{
    vbss_view kinds, points;
    vec sum = v3(0.0, 0.0, 0.0);
    double smallest = 1.0, largest = -1.0;
    uint32_t count = 0, end = limb_end(s);
    TRY(vbss_scene_get_view(s->rig->scene, VBSS_SCENE_VIEW_CONTACTS, &kinds, sizeof kinds));
    TRY(vbss_scene_get_view(s->rig->scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &points, sizeof points));
    for (uint64_t i = 0; i < kinds.count; i++) {
        if (is_of_knot(s, contact_at(&kinds, i), end)) {
            vec at = point_at(&points, i);
            sum = v_add(sum, at);
            smallest = smaller(smallest, height_above_drain(at));
            largest = larger(largest, height_above_drain(at));
            count++;
        }
    }
    if (count > 0) {
        s->knot = v_scale(1.0 / count, sum);
        s->knot_height = height_above_drain(s->knot);
        s->knot_lowest = smallest;
        s->knot_highest = largest;
    }
    return VBSS_OK;
}

/* ---- where tail and limb come out of it */

static void include(senses *s, uint32_t segment)
{
    s->tail_root = segment < s->tail_root ? segment : s->tail_root;
    s->limb_root = segment + 1 > s->limb_root ? segment + 1 : s->limb_root;
}

/* Of a tight knot, whose throws the detector cannot place: where the thread touches itself, not far from the middle. */
static vbss_result find_roots_by_touch(senses *s)
{
    vbss_view kinds, points;
    TRY(senses_find_knot(s));
    TRY(vbss_scene_get_view(s->rig->scene, VBSS_SCENE_VIEW_CONTACTS, &kinds, sizeof kinds));
    TRY(vbss_scene_get_view(s->rig->scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &points, sizeof points));
    uint32_t end = limb_end(s);
    s->tail_root = s->rig->marks[0];
    s->limb_root = s->rig->marks[1];
    for (uint64_t i = 0; i < kinds.count; i++) {
        const uint32_t *c = contact_at(&kinds, i);
        if (is_of_knot(s, c, end) && v_distance(point_at(&points, i), s->knot) < KNOT_SIZE) {
            include(s, throw_rig_segment(s->rig, c[2]));
            include(s, throw_rig_segment(s->rig, c[4]));
        }
    }
    return VBSS_OK;
}

/* What hangs about may cross itself far out, and the detector counts that in: what touches is nearer to the knot. */
static bool reaches_out(const senses *s, const vbss_knot_throw *last)
{
    return (uint32_t)last->tail_places[0] + FARTHER < s->tail_root ||
           (uint32_t)last->long_places[1] > s->limb_root + FARTHER;
}

vbss_result senses_find_roots(senses *s)
{
    senses_knot k;
    TRY(senses_judge(s, false, &k));
    s->throws = k.state.throw_count;
    if (s->throws > 0) {
        vbss_knot_throw last;
        TRY(vbss_knot_detector_get_throw(s->arbiter, s->throws - 1, &last, sizeof last));
        TRY(find_roots_by_touch(s));
        if ((last.flags & VBSS_KNOT_THROW_LOCATED) != 0 && !reaches_out(s, &last)) {
            s->tail_root = (uint32_t)last.tail_places[0];
            s->limb_root = (uint32_t)last.long_places[1] + 1;
        }
    }
    return VBSS_OK;
}
