#include "movie.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NOT_FOUND = 127, ENDS = 2 };

/* In the child; H.264 wants even sides, a player a pixel format of 4:2:0. */
static void become_ffmpeg(const char *path, const char *size, const char *rate)
{
    const char *words[] = {"ffmpeg",
                           "-loglevel",
                           "error",
                           "-y",
                           "-f",
                           "rawvideo",
                           "-pix_fmt",
                           "rgb24",
                           "-s",
                           size,
                           "-r",
                           rate,
                           "-i",
                           "-",
                           "-an",
                           "-vf",
                           "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                           "-c:v",
                           "libx264",
                           "-crf",
                           "20",
                           "-pix_fmt",
                           "yuv420p",
                           "-movflags",
                           "+faststart",
                           "-f",
                           "mp4",
                           path,
                           NULL};
    char *copies[sizeof words / sizeof *words];
    memcpy(copies, words, sizeof words);
    (void)execvp("ffmpeg", copies);
    _exit(NOT_FOUND);
}

bool movie_possible(void)
{
    const char *path = getenv("PATH");
    bool found = false;
    while (path != NULL && *path != '\0' && !found) {
        char place[1024];
        const int length = (int)strcspn(path, ":");
        const int used = snprintf(place, sizeof place, "%.*s/ffmpeg", length, path);
        found = used < (int)sizeof place && access(place, X_OK) == 0;
        path += length + (path[length] == ':' ? 1 : 0);
    }
    return found;
}

bool movie_begin(movie *f, const char *path, int width, int height, int rate)
{
    int ends[ENDS];
    char size[32], number[16], place[1024];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(number, sizeof number, "%d", rate);
    /* no name is an option or a protocol of ffmpeg's */
    const int length = snprintf(place, sizeof place, "file:%s", path);
    *f = (movie){.pipe = -1, .width = width, .height = height};
    if (length >= (int)sizeof place || pipe(ends) != 0) {
        fprintf(stderr, "viewer: no film can be begun\n");
        return false;
    }
    (void)signal(SIGPIPE, SIG_IGN); /* a write tells */
    f->child = fork();
    if (f->child == 0) {
        (void)dup2(ends[0], STDIN_FILENO);
        (void)close(ends[0]);
        (void)close(ends[1]);
        become_ffmpeg(place, size, number);
    }
    (void)close(ends[0]);
    f->pipe = ends[1];
    return f->child > 0;
}

bool movie_add(const movie *f, const uint8_t *pixels)
{
    size_t left = 3 * (size_t)f->width * (size_t)f->height;
    while (left > 0) {
        const ssize_t gone = write(f->pipe, pixels, left);
        if (gone < 0 && errno == EINTR) {
            continue;
        }
        if (gone <= 0) {
            return false;
        }
        pixels += gone;
        left -= (size_t)gone;
    }
    return true;
}

bool movie_end(movie *f)
{
    int status = -1;
    (void)close(f->pipe);
    const bool ended = waitpid(f->child, &status, 0) == f->child && WIFEXITED(status);
    if (ended && WEXITSTATUS(status) == NOT_FOUND) {
        fprintf(stderr, "viewer: there is no ffmpeg; .ci/install-packages viewer installs it\n");
    } else if (!ended || WEXITSTATUS(status) != 0) {
        fprintf(stderr, "viewer: ffmpeg has failed\n");
    }
    return ended && WEXITSTATUS(status) == 0;
}
