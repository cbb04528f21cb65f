#include "headless.h"

#include <stdio.h>

#include <epoxy/egl.h>

static bool refuse(const char *what)
{
    fprintf(stderr, "viewer: no %s without a window (EGL error 0x%x)\n", what,
            (unsigned)eglGetError());
    return false;
}

static EGLDisplay find_display(void)
{
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

bool headless_begin(headless *h)
{
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             3,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    const EGLint kind[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    h->context = EGL_NO_CONTEXT;
    h->display = find_display();
    if (h->display == EGL_NO_DISPLAY || !eglInitialize(h->display, NULL, NULL)) {
        return refuse("display");
    }
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(h->display, kind, &config, 1, &count) ||
        count == 0) {
        return refuse("OpenGL");
    }
    h->context = eglCreateContext(h->display, config, EGL_NO_CONTEXT, wanted);
    if (h->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(h->display, EGL_NO_SURFACE, EGL_NO_SURFACE, h->context)) {
        return refuse("context of OpenGL 3.3");
    }
    return true;
}

void headless_end(headless *h)
{
    if (h->display != EGL_NO_DISPLAY) {
        eglMakeCurrent(h->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (h->context != EGL_NO_CONTEXT) {
            eglDestroyContext(h->display, h->context);
        }
        eglTerminate(h->display);
    }
}
