/* Where a picture is looked at from: cameras, and the way from metres to pixels. */
#include "picture.h"

#include <string.h>

static vec unit(vec a)
{
    return vec_scale(a, 1.0 / vec_length(a));
}

/* ---- cameras */

static bool is_plain(const double v[3])
{
    return fabs(v[0]) <= 1e6 && fabs(v[1]) <= 1e6 && fabs(v[2]) <= 1e6;
}

/* Two directions that span a plane. */
static bool are_apart(vec a, vec b)
{
    double la = vec_length(a), lb = vec_length(b);
    return la > 1e-12 && lb > 1e-12 && vec_length(vec_cross(a, b)) > 1e-6 * la * lb;
}

painter_result painter_set_camera(painter *p, const painter_camera *camera)
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (camera == NULL) {
        return picture_need(p, camera, "the camera");
    }
    if (!is_plain(camera->eye) || !is_plain(camera->target) || !is_plain(camera->up)) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "the camera is not of numbers up to 1e6");
    }
    vec forward = vec_sub(vec_of(camera->target), vec_of(camera->eye));
    if (!are_apart(forward, vec_of(camera->up))) {
        return picture_fail(p, PAINTER_ERROR_NUMBER,
                            "the camera's target is at its eye, or its up is along its view");
    }
    if (camera->width == 0.0 ? !(camera->angle >= 0.01 && camera->angle <= 2.8)
                             : !(camera->width >= 1e-6 && camera->width <= 1e6)) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "the camera's width or angle is out of range");
    }
    p->camera = *camera;
    p->has_camera = true;
    return PAINTER_OK;
}

painter_camera camera_from_above(const painter_camera *camera)
{
    vec target = vec_of(camera->target), to_target = vec_sub(target, vec_of(camera->eye));
    vec forward = unit(to_target), up = vec_of(camera->up);
    up = unit(vec_sub(up, vec_scale(forward, vec_dot(up, forward))));
    vec eye = vec_add(target, vec_scale(up, vec_length(to_target)));
    painter_camera above = *camera;
    memcpy(above.eye, (double[3]){eye.x, eye.y, eye.z}, sizeof above.eye);
    memcpy(above.up, (double[3]){forward.x, forward.y, forward.z}, sizeof above.up);
    return above;
}

/* ---- all that was added, in sight */

typedef struct extent {
    vec low, high; /* along right, up, forward */
    bool any;
} extent;

static void reach(extent *e, vec place, double radius)
{
    vec low = {place.x - radius, place.y - radius, place.z - radius};
    vec high = {place.x + radius, place.y + radius, place.z + radius};
    if (!e->any) {
        *e = (extent){low, high, true};
        return;
    }
    e->low = (vec){fmin(e->low.x, low.x), fmin(e->low.y, low.y), fmin(e->low.z, low.z)};
    e->high = (vec){fmax(e->high.x, high.x), fmax(e->high.y, high.y), fmax(e->high.z, high.z)};
}

static extent extent_of(const painter *p, const view *v)
{
    extent e = {.any = false};
    for (size_t i = 0; i < p->shape_count; i++) {
        shape s = shape_placed(v, &p->shapes[i]);
        bool flat = s.kind == SHAPE_TRIANGLE || s.kind == SHAPE_FLOOR;
        double radius = p->shapes[i].radius; /* as it is, not as it is painted */
        reach(&e, s.a, radius);
        reach(&e, flat ? vec_add(s.a, s.b) : s.b, radius);
        if (flat) {
            reach(&e, vec_add(s.a, s.c), 0.0);
        }
        if (s.kind == SHAPE_FLOOR) {
            reach(&e, vec_add(vec_add(s.a, s.b), s.c), 0.0);
        }
    }
    for (size_t i = 0; i < p->dot_count; i++) {
        reach(&e, view_place(v, p->dots[i].centre), 0.0);
    }
    for (size_t i = 0; i < p->caption_count; i++) {
        if (p->captions[i].in_scene) {
            reach(&e, view_place(v, p->captions[i].point), 0.0);
        }
    }
    return e;
}

/* Seen from both sides of the two views it fits as well: its width covers depth like height. */
static painter_camera fitted(const painter *p, vec direction, vec up)
{
    const double border = 1.14;
    painter_camera camera = {.width = 1.0};
    vec eye = vec_scale(unit(direction), -1.0);
    memcpy(camera.eye, (double[3]){eye.x, eye.y, eye.z}, sizeof camera.eye);
    memcpy(camera.up, (double[3]){up.x, up.y, up.z}, sizeof camera.up);
    view v = view_of(&camera, p->width, p->height);
    extent e = extent_of(p, &v);
    vec middle = vec_scale(vec_add(e.low, e.high), 0.5), size = vec_sub(e.high, e.low);
    double aspect = (double)p->width / p->height;
    double width = border * fmax(size.x, fmax(size.y, size.z) * aspect);
    camera.width = clamp(e.any ? width : 0.1, 1e-6, 1e6);
    double back = fmax(size.z, camera.width);
    vec target =
        vec_add(v.eye, vec_add(vec_scale(v.right, middle.x),
                               vec_add(vec_scale(v.up, middle.y), vec_scale(v.forward, middle.z))));
    vec from = vec_sub(target, vec_scale(v.forward, back));
    memcpy(camera.target, (double[3]){target.x, target.y, target.z}, sizeof camera.target);
    memcpy(camera.eye, (double[3]){from.x, from.y, from.z}, sizeof camera.eye);
    return camera;
}

painter_result painter_fit_camera(painter *p, const double direction[3], const double up[3])
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (direction == NULL || up == NULL) {
        return picture_need(p, NULL, direction == NULL ? "direction" : "up");
    }
    if (!is_plain(direction) || !is_plain(up) || !are_apart(vec_of(direction), vec_of(up))) {
        return picture_fail(p, PAINTER_ERROR_NUMBER,
                            "direction and up are not two directions of numbers up to 1e6");
    }
    p->camera = fitted(p, vec_of(direction), vec_of(up));
    p->has_camera = true;
    return PAINTER_OK;
}

painter_camera camera_in_use(const painter *p)
{
    return p->has_camera ? p->camera : fitted(p, (vec){0.0, 0.0, -1.0}, (vec){0.0, 1.0, 0.0});
}

painter_result painter_get_camera(painter *p, painter_camera *camera)
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (camera == NULL) {
        return picture_need(p, camera, "the camera");
    }
    *camera = camera_in_use(p);
    return PAINTER_OK;
}

/* ---- from metres to pixels and back */

view view_of(const painter_camera *camera, int width, int height)
{
    view v = {.eye = vec_of(camera->eye), .width = width, .height = height};
    vec to_target = vec_sub(vec_of(camera->target), v.eye);
    v.forward = unit(to_target);
    v.right = unit(vec_cross(v.forward, vec_of(camera->up)));
    v.up = vec_cross(v.right, v.forward);
    v.perspective = !(camera->width > 0.0);
    v.scale = v.perspective ? 0.5 * width / tan(0.5 * camera->angle) : width / camera->width;
    v.middle_x = 0.5 * width;
    v.middle_y = 0.5 * height;
    v.near = 1e-3 * vec_length(to_target);
    return v;
}

view view_enlarged(const view *v, int times)
{
    view large = *v;
    large.width *= times;
    large.height *= times;
    large.scale *= times;
    large.middle_x *= times;
    large.middle_y *= times;
    return large;
}

vec view_turn(const view *v, vec direction)
{
    return (vec){vec_dot(direction, v->right), vec_dot(direction, v->up),
                 vec_dot(direction, v->forward)};
}

vec view_place(const view *v, vec point)
{
    return view_turn(v, vec_sub(point, v->eye));
}

double view_scale_at(const view *v, double z)
{
    return v->perspective ? v->scale / fmax(z, v->near) : v->scale;
}

bool view_project(const view *v, vec place, double *x, double *y)
{
    if (v->perspective && place.z <= v->near) {
        return false;
    }
    double scale = view_scale_at(v, place.z);
    *x = v->middle_x + place.x * scale;
    *y = v->middle_y - place.y * scale;
    return true;
}

ray view_ray(const view *v, double x, double y)
{
    vec at = {(x - v->middle_x) / v->scale, (v->middle_y - y) / v->scale, 1.0};
    if (v->perspective) {
        return (ray){{0.0, 0.0, 0.0}, vec_scale(at, 1.0 / vec_length(at))};
    }
    at.z = 0.0;
    return (ray){at, {0.0, 0.0, 1.0}};
}
