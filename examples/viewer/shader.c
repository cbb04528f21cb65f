#include "shader.h"

#include <stdio.h>

static GLuint compile(const char *name, GLenum stage, const char *const *text, int pieces)
{
    GLuint shader = glCreateShader(stage);
    GLint good = GL_FALSE;
    char reported[1024];
    glShaderSource(shader, pieces, text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_FALSE) {
        glGetShaderInfoLog(shader, sizeof reported, NULL, reported);
        fprintf(stderr, "viewer: shader %s: %s\n", name, reported);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint shader_program(const char *name, const char *vertex, const char *const *fragment, int pieces)
{
    GLuint v = compile(name, GL_VERTEX_SHADER, &vertex, 1);
    GLuint f = compile(name, GL_FRAGMENT_SHADER, fragment, pieces);
    GLuint program = glCreateProgram();
    GLint good = GL_FALSE;
    if (v != 0 && f != 0) {
        glAttachShader(program, v);
        glAttachShader(program, f);
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &good);
    }
    glDeleteShader(v);
    glDeleteShader(f);
    if (good == GL_FALSE) {
        fprintf(stderr, "viewer: program %s does not link\n", name);
        glDeleteProgram(program);
        return 0;
    }
    return program;
}
