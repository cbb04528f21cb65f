#include "lens.h"

#include <string.h>

#include "shader.h"

static const char vertex[] = "#version 330 core\n"
                             "out vec2 at;\n"
                             "void main() {\n" /* one triangle over all of the picture */
                             "    at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
                             "    gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);\n"
                             "}\n";
static const char *const fragment =
    "#version 330 core\n"
    "in vec2 at;\n"
    "out vec4 colour;\n"
    "uniform sampler2D light;\n"
    "uniform float aspect, barrel, spread;\n"
    "void main() {\n"
    "    vec2 p = 2.0 * at - 1.0;\n"
    "    vec2 round = vec2(p.x * aspect, p.y);\n" /* 1 at the upper edge */
    "    float r2 = dot(round, round);\n"
    "    vec2 bent = p * (1.0 + barrel * r2) / spread;\n"
    "    vec3 c = texture(light, 0.5 * bent + 0.5).rgb;\n"
    "    c *= 1.0 - 0.42 * smoothstep(0.1, 1.3, r2);\n"                 /* less light aside */
    "    c *= 1.0 - smoothstep(1.08, 1.13, sqrt(r2));\n"                /* the round field */
    "    c = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);\n" /* tone: Narkowicz 2015 */
    "    colour = vec4(pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);\n"
    "}\n";

static GLuint texture_of(GLint format, int width, int height)
{
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

static bool is_whole(void)
{
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static bool begin_many(lens *l)
{
    glGenRenderbuffers(1, &l->colour);
    glBindRenderbuffer(GL_RENDERBUFFER, l->colour);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, LENS_SAMPLES, GL_RGBA16F, l->width,
                                     l->height);
    glGenRenderbuffers(1, &l->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, l->depth);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, LENS_SAMPLES, GL_DEPTH_COMPONENT24, l->width,
                                     l->height);
    glGenFramebuffers(1, &l->many);
    glBindFramebuffer(GL_FRAMEBUFFER, l->many);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, l->colour);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, l->depth);
    return is_whole();
}

static bool begin_single(GLint format, const lens *l, GLuint *frame, GLuint *texture)
{
    *texture = texture_of(format, l->width, l->height);
    glGenFramebuffers(1, frame);
    glBindFramebuffer(GL_FRAMEBUFFER, *frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *texture, 0);
    return is_whole();
}

bool lens_begin(lens *l, int width, int height)
{
    l->width = width;
    l->height = height;
    l->program = shader_program("lens", vertex, &fragment, 1);
    glGenVertexArrays(1, &l->empty);
    return begin_many(l) && begin_single(GL_RGBA16F, l, &l->one, &l->light) &&
           begin_single(GL_RGBA8, l, &l->out, &l->picture) && l->program != 0;
}

void lens_end(lens *l)
{
    const GLuint frames[3] = {l->many, l->one, l->out}, rooms[2] = {l->colour, l->depth},
                 textures[2] = {l->light, l->picture};
    glDeleteFramebuffers(3, frames);
    glDeleteRenderbuffers(2, rooms);
    glDeleteTextures(2, textures);
    glDeleteVertexArrays(1, &l->empty);
    glDeleteProgram(l->program);
}

void lens_open(const lens *l)
{
    glBindFramebuffer(GL_FRAMEBUFFER, l->many);
    glViewport(0, 0, l->width, l->height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void lens_close(const lens *l)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l->many);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, l->one);
    glBlitFramebuffer(0, 0, l->width, l->height, 0, 0, l->width, l->height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, l->out);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(l->program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, l->light);
    glUniform1i(glGetUniformLocation(l->program, "light"), 0);
    glUniform1f(glGetUniformLocation(l->program, "aspect"), (float)l->width / (float)l->height);
    glUniform1f(glGetUniformLocation(l->program, "barrel"), LENS_BARREL);
    glUniform1f(glGetUniformLocation(l->program, "spread"), LENS_SPREAD);
    glBindVertexArray(l->empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* The cubic is solved by repetition: it is nearly 1. */
void lens_bend(const lens *l, float place[2])
{
    enum { ROUNDS = 12 };
    const float aspect = (float)l->width / (float)l->height;
    const float x = place[0] * LENS_SPREAD, y = place[1] * LENS_SPREAD;
    place[0] = x;
    place[1] = y;
    for (int i = 0; i < ROUNDS; i++) {
        float across = place[0] * aspect, r2 = across * across + place[1] * place[1];
        float share = 1.0F / (1.0F + LENS_BARREL * r2);
        place[0] = x * share;
        place[1] = y * share;
    }
}

/* OpenGL's rows begin at the bottom. */
void lens_read(const lens *l, uint8_t *pixels)
{
    glBindFramebuffer(GL_FRAMEBUFFER, l->out);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < l->height; y++) {
        glReadPixels(0, l->height - 1 - y, l->width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                     pixels + 3 * (size_t)l->width * (size_t)y);
    }
}

void lens_show(const lens *l, int width, int height)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l->out);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, l->width, l->height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
}
