/* What is added to a painter's scene. */
#include "picture.h"

#include <string.h>

#define TRY(call)                           \
    do {                                    \
        painter_result try_result = (call); \
        if (try_result != PAINTER_OK) {     \
            return try_result;              \
        }                                   \
    } while (0)
#define TRY_PAINTER(p)                 \
    do {                               \
        if ((p) == NULL) {             \
            return PAINTER_ERROR_NULL; \
        }                              \
    } while (0)

static painter_result room_for_shapes(painter *p, size_t more)
{
    void *array = p->shapes;
    painter_result result =
        picture_make_room(p, &array, &p->shape_room, p->shape_count, more, sizeof *p->shapes);
    p->shapes = array;
    return result;
}

static void add_shape(painter *p, shape s)
{
    s.strand = p->strands;
    p->shapes[p->shape_count++] = s;
}

/* ---- shapes */

painter_result painter_add_capsule(painter *p, const double a[3], const double b[3], double radius,
                                   painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_point(p, a, "a"));
    TRY(picture_check_point(p, b, "b"));
    TRY(picture_check_range(p, radius, 1e-9, PICTURE_LARGEST, "the radius"));
    TRY(picture_check_colour(p, colour));
    TRY(room_for_shapes(p, 1));
    add_shape(p, (shape){.kind = SHAPE_CAPSULE,
                         .colour = colour,
                         .a = vec_of(a),
                         .b = vec_of(b),
                         .radius = radius});
    p->strands++;
    return PAINTER_OK;
}

static void add_path(painter *p, shape s, const double *positions, size_t count, size_t stride,
                     const painter_colour *segment_colours)
{
    for (size_t i = 0; i + 1 < count || (i == 0 && count == 1); i++) {
        s.a = picture_point(positions, stride, i);
        s.b = count == 1 ? s.a : picture_point(positions, stride, i + 1);
        s.colour = segment_colours != NULL && count > 1 ? segment_colours[i] : s.colour;
        add_shape(p, s);
        s.start += vec_length(vec_sub(s.b, s.a));
    }
    p->strands++;
}

painter_result painter_add_chain(painter *p, const double *positions, size_t count,
                                 size_t stride_bytes, double radius, painter_colour colour,
                                 const painter_colour *segment_colours)
{
    TRY_PAINTER(p);
    TRY(picture_check_points(p, positions, count, &stride_bytes));
    TRY(picture_check_range(p, radius, 1e-9, PICTURE_LARGEST, "the radius"));
    TRY(picture_check_colour(p, colour));
    for (size_t i = 0; segment_colours != NULL && i + 1 < count; i++) {
        TRY(picture_check_colour(p, segment_colours[i]));
    }
    TRY(room_for_shapes(p, count));
    add_path(p, (shape){.kind = SHAPE_CAPSULE, .colour = colour, .radius = radius}, positions,
             count, stride_bytes, segment_colours);
    return PAINTER_OK;
}

painter_result painter_add_lines(painter *p, const double *positions, size_t count,
                                 size_t stride_bytes, painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_points(p, positions, count, &stride_bytes));
    TRY(picture_check_colour(p, colour));
    TRY(room_for_shapes(p, count));
    add_path(p, (shape){.kind = SHAPE_LINE, .colour = colour}, positions, count, stride_bytes,
             NULL);
    return PAINTER_OK;
}

painter_result painter_add_triangles(painter *p, const double *vertices, size_t vertex_count,
                                     size_t stride_bytes, const uint32_t *indices,
                                     size_t triangle_count, painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_points(p, vertices, vertex_count, &stride_bytes));
    TRY(picture_need(p, indices, "the array of indices"));
    TRY(picture_check_colour(p, colour));
    if (triangle_count > (1u << 26)) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "too many triangles");
    }
    for (size_t i = 0; i < 3 * triangle_count; i++) {
        if (indices[i] >= vertex_count) {
            return picture_fail(p, PAINTER_ERROR_NUMBER, "index %zu is not of a vertex", i);
        }
    }
    TRY(room_for_shapes(p, triangle_count));
    for (size_t i = 0; i < triangle_count; i++) {
        vec a = picture_point(vertices, stride_bytes, indices[3 * i]);
        vec b = picture_point(vertices, stride_bytes, indices[3 * i + 1]);
        vec c = picture_point(vertices, stride_bytes, indices[3 * i + 2]);
        add_shape(p, (shape){.kind = SHAPE_TRIANGLE,
                             .colour = colour,
                             .a = a,
                             .b = vec_sub(b, a),
                             .c = vec_sub(c, a)});
    }
    p->strands++;
    return PAINTER_OK;
}

painter_result painter_add_floor(painter *p, const double centre[3], const double u[3],
                                 const double v[3], int cells, painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_point(p, centre, "centre"));
    TRY(picture_check_point(p, u, "u"));
    TRY(picture_check_point(p, v, "v"));
    TRY(picture_check_range(p, cells, 1, 1000, "the number of cells"));
    TRY(picture_check_colour(p, colour));
    vec normal = vec_cross(vec_of(u), vec_of(v));
    if (!(vec_length(normal) > 1e-9 * vec_length(vec_of(u)) * vec_length(vec_of(v)))) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "u and v are parallel, or zero");
    }
    TRY(room_for_shapes(p, 1));
    vec corner = vec_sub(vec_sub(vec_of(centre), vec_of(u)), vec_of(v));
    add_shape(p, (shape){.kind = SHAPE_FLOOR,
                         .colour = colour,
                         .a = corner,
                         .b = vec_scale(vec_of(u), 2.0),
                         .c = vec_scale(vec_of(v), 2.0),
                         .cells = cells});
    p->strands++;
    return PAINTER_OK;
}

painter_result painter_add_dots(painter *p, const double *positions, size_t count,
                                size_t stride_bytes, double pixels, painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_points(p, positions, count, &stride_bytes));
    TRY(picture_check_range(p, pixels, 0.5, 100.0, "the radius in pixels"));
    TRY(picture_check_colour(p, colour));
    void *array = p->dots;
    painter_result result =
        picture_make_room(p, &array, &p->dot_room, p->dot_count, count, sizeof *p->dots);
    p->dots = array;
    for (size_t i = 0; result == PAINTER_OK && i < count; i++) {
        p->dots[p->dot_count++] = (dot){picture_point(positions, stride_bytes, i), pixels, colour};
    }
    return result;
}

/* ---- text */

static void copy_text(char to[TEXT_SIZE], const char *text)
{
    size_t length = 0;
    while (length < TEXT_SIZE - 1 && text[length] != '\0') {
        length++;
    }
    /* Not in the middle of a character. */
    while (text[length] != '\0' && length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80) {
        length--;
    }
    memcpy(to, text, length);
    to[length] = '\0';
}

static painter_result add_caption(painter *p, bool in_scene, vec point, const char *text,
                                  painter_colour colour)
{
    TRY(picture_need(p, text, "the text"));
    TRY(picture_check_colour(p, colour));
    void *array = p->captions;
    painter_result result =
        picture_make_room(p, &array, &p->caption_room, p->caption_count, 1, sizeof *p->captions);
    p->captions = array;
    if (result == PAINTER_OK) {
        caption *c = &p->captions[p->caption_count++];
        *c = (caption){.in_scene = in_scene, .point = point, .colour = colour};
        copy_text(c->text, text);
    }
    return result;
}

painter_result painter_add_text(painter *p, double x, double y, const char *text,
                                painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_range(p, x, -1e5, 1e5, "x"));
    TRY(picture_check_range(p, y, -1e5, 1e5, "y"));
    return add_caption(p, false, (vec){x, y, 0.0}, text, colour);
}

painter_result painter_add_label(painter *p, const double point[3], const char *text,
                                 painter_colour colour)
{
    TRY_PAINTER(p);
    TRY(picture_check_point(p, point, "point"));
    return add_caption(p, true, vec_of(point), text, colour);
}

painter_result painter_add_scale_bar(painter *p, double length, const char *text)
{
    TRY_PAINTER(p);
    TRY(picture_check_range(p, length, 1e-9, PICTURE_LARGEST, "the length"));
    TRY(picture_need(p, text, "the text"));
    p->bar_length = length;
    copy_text(p->bar_text, text);
    return PAINTER_OK;
}

painter_result painter_add_ramp(painter *p, const char *low, const char *high)
{
    TRY_PAINTER(p);
    TRY(picture_need(p, low, "the text"));
    TRY(picture_need(p, high, "the text"));
    p->has_ramp = true;
    copy_text(p->ramp_low, low);
    copy_text(p->ramp_high, high);
    return PAINTER_OK;
}
