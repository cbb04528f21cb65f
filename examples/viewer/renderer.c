#include "renderer.h"

#include <stddef.h>
#include <stdio.h>

#include "materials.h"
#include "shader.h"

enum { FLOATS = 12, MAX_DECALS = 32, PART_WORDS = 8, DECAL_FLOATS = 6 };

/* ---- what stays */

/* OpenGL takes places in a buffer for pointers. */
static const void *place(size_t bytes)
{
    return (const void *)(uintptr_t)bytes; /* NOLINT(performance-no-int-to-ptr) */
}

static void describe_vertices(void)
{
    const struct {
        GLint count;
        size_t first;
    } fields[5] = {{3, 0}, {3, 3}, {2, 6}, {3, 8}, {1, 11}};
    for (GLuint i = 0; i < 5; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, fields[i].count, GL_FLOAT, GL_FALSE, FLOATS * sizeof(float),
                              place(fields[i].first * sizeof(float)));
    }
}

bool renderer_begin(renderer *r, int width, int height)
{
    r->program = shader_program("materials", material_vertex, material_fragment, MATERIAL_PIECES);
    glGenVertexArrays(1, &r->vertex_array);
    glBindVertexArray(r->vertex_array);
    glGenBuffers(1, &r->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, r->vertices);
    glGenBuffers(1, &r->triangles);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, r->triangles);
    describe_vertices();
    bool good = shadow_begin(&r->shadow) && lens_begin(&r->lens, width, height);
    if (!good || r->program == 0 || glGetError() != GL_NO_ERROR) {
        fprintf(stderr, "viewer: OpenGL lacks something\n");
        return false;
    }
    return true;
}

bool renderer_resize(renderer *r, int width, int height)
{
    lens_end(&r->lens);
    return lens_begin(&r->lens, width, height) && renderer_good();
}

void renderer_end(renderer *r)
{
    const GLuint buffers[2] = {r->vertices, r->triangles};
    lens_end(&r->lens);
    shadow_end(&r->shadow);
    glDeleteBuffers(2, buffers);
    glDeleteVertexArrays(1, &r->vertex_array);
    glDeleteProgram(r->program);
}

/* ---- a frame */

typedef struct meshes {
    vbss_view vertices, triangles, parts, decals;
} meshes;

static bool get_views(vbss_visual *visual, meshes *m)
{
    vbss_view *views[4] = {&m->vertices, &m->triangles, &m->parts, &m->decals};
    for (vbss_visual_field field = 0; field < 4; field++) {
        if (vbss_visual_get_view(visual, field, views[field], sizeof m->vertices) != VBSS_OK) {
            return false;
        }
    }
    return true;
}

static void upload(const renderer *r, const meshes *m)
{
    glBindVertexArray(r->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, r->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(m->vertices.count * m->vertices.stride_bytes),
                 m->vertices.data, GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 (GLsizeiptr)(m->triangles.count * m->triangles.stride_bytes), m->triangles.data,
                 GL_STREAM_DRAW);
}

static bool is_ghost(const renderer *r, const uint32_t *part)
{
    return r->ghost != 0 && part[1] == r->ghost;
}

static void draw_part(const uint32_t *part)
{
    glDrawElements(GL_TRIANGLES, (GLsizei)(3 * part[6]), GL_UNSIGNED_INT,
                   place(3 * sizeof(uint32_t) * (size_t)part[5]));
}

/* Tools are led from behind the camera: one before the lens would hide what the other one does. */
static float clear_of(const uint32_t *part, const camera *c)
{
    return part[0] == VBSS_VISUAL_KIND_DRIVER || part[0] == VBSS_VISUAL_KIND_SHEARS ? c->clear
                                                                                    : 0.0F;
}

static void draw_shadows(const renderer *r, const meshes *m, const camera_view *view,
                         const camera *c)
{
    shadow_cast(&r->shadow, &view->light);
    const uint32_t *parts = m->parts.data;
    for (uint64_t i = 0; i < m->parts.count; i++) {
        shadow_clear(&r->shadow, view->lamp, clear_of(parts + PART_WORDS * i, c));
        if (parts[PART_WORDS * i] != VBSS_VISUAL_KIND_FLOOR && /* which is below everything */
            !is_ghost(r, parts + PART_WORDS * i)) {
            draw_part(parts + PART_WORDS * i);
        }
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

static GLint named(const renderer *r, const char *name)
{
    return glGetUniformLocation(r->program, name);
}

/* Marks first. */
static void set_decals(const renderer *r, const meshes *m, uint64_t part)
{
    float decals[MAX_DECALS][4];
    GLint count = 0, marks = 0;
    const float *rows = m->decals.data;
    for (int kind = VBSS_VISUAL_SPOT_MARK; kind <= VBSS_VISUAL_SPOT_HOLE; kind++) {
        for (uint64_t i = 0; i < m->decals.count && count < MAX_DECALS; i++) {
            const float *row = rows + DECAL_FLOATS * i;
            if ((uint64_t)row[0] == part && (int)row[1] == kind) {
                for (int k = 0; k < 4; k++) {
                    decals[count][k] = row[2 + k];
                }
                count++;
            }
        }
        marks = kind == VBSS_VISUAL_SPOT_MARK ? count : marks;
    }
    glUniform1i(named(r, "spot_count"), count);
    glUniform1i(named(r, "mark_count"), marks);
    if (count > 0) {
        glUniform4fv(named(r, "spots"), count, &decals[0][0]);
    }
}

static void draw_seen(const renderer *r, const meshes *m, const camera_view *view, const camera *c)
{
    lens_open(&r->lens);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glUseProgram(r->program);
    glUniformMatrix4fv(named(r, "seen"), 1, GL_FALSE, view->seen.m);
    glUniformMatrix4fv(named(r, "light"), 1, GL_FALSE, view->light.m);
    glUniform3f(named(r, "eye"), view->eye.x, view->eye.y, view->eye.z);
    glUniform3f(named(r, "lamp"), view->lamp.x, view->lamp.y, view->lamp.z);
    glUniform1f(named(r, "brightness"), MATERIAL_BRIGHTNESS * c->gain);
    glUniform1f(named(r, "most_tension"), r->max_tension);
    glUniform1f(named(r, "gone"), CAMERA_GONE);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, r->shadow.depth);
    glUniform1i(named(r, "shadow"), 0);
    const uint32_t *parts = m->parts.data;
    for (uint64_t i = 0; i < m->parts.count; i++) {
        glUniform1i(named(r, "kind"), (GLint)parts[PART_WORDS * i]);
        glUniform1f(named(r, "clear"), clear_of(parts + PART_WORDS * i, c));
        glUniform1i(named(r, "ghost"), is_ghost(r, parts + PART_WORDS * i));
        set_decals(r, m, i);
        draw_part(parts + PART_WORDS * i);
    }
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

bool renderer_good(void)
{
    GLenum error = glGetError();
    if (error == GL_NO_ERROR || error == GL_CONTEXT_LOST) { /* the window makes it anew */
        return true;
    }
    fprintf(stderr, "viewer: OpenGL error 0x%x\n", (unsigned)error);
    return false;
}

bool renderer_draw(renderer *r, vbss_visual *visual, const camera *c)
{
    meshes m;
    if (!get_views(visual, &m)) {
        return false;
    }
    const camera_view view = camera_get_view(c, (float)r->lens.width / (float)r->lens.height);
    glEnable(GL_DEPTH_TEST);
    upload(r, &m);
    draw_shadows(r, &m, &view, c);
    draw_seen(r, &m, &view, c);
    lens_close(&r->lens);
    return renderer_good();
}
