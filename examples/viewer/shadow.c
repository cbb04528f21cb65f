#include "shadow.h"

#include "programs.h"
#include "shader.h"

bool shadow_begin(shadow *s)
{
    s->program = shader_program("shadow", shadow_vertex, &shadow_fragment, 1);
    glGenTextures(1, &s->depth);
    glBindTexture(GL_TEXTURE_2D, s->depth);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, SHADOW_SIZE, SHADOW_SIZE, 0,
                 GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glGenFramebuffers(1, &s->frame);
    glBindFramebuffer(GL_FRAMEBUFFER, s->frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, s->depth, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return s->program != 0 && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void shadow_end(shadow *s)
{
    glDeleteFramebuffers(1, &s->frame);
    glDeleteTextures(1, &s->depth);
    glDeleteProgram(s->program);
}

void shadow_cast(const shadow *s, const matrix4 *light)
{
    glBindFramebuffer(GL_FRAMEBUFFER, s->frame);
    glViewport(0, 0, SHADOW_SIZE, SHADOW_SIZE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glUseProgram(s->program);
    glUniformMatrix4fv(glGetUniformLocation(s->program, "light"), 1, GL_FALSE, light->m);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2.0F, 4.0F);
}

void shadow_clear(const shadow *s, point3 lamp, float clear)
{
    glUniform3f(glGetUniformLocation(s->program, "lamp"), lamp.x, lamp.y, lamp.z);
    glUniform1f(glGetUniformLocation(s->program, "clear"), clear);
}
