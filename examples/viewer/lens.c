#include "lens.h"

#include <string.h>

#include "barrel.h"
#include "programs.h"
#include "shader.h"

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
    l->program = shader_program("lens", lens_vertex, &lens_fragment, 1);
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
    glUniform1f(glGetUniformLocation(l->program, "barrel"), BARREL);
    glUniform1f(glGetUniformLocation(l->program, "spread"), BARREL_SPREAD);
    glUniform1f(glGetUniformLocation(l->program, "field"), 1.0F);
    glBindVertexArray(l->empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
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
