#include "throw/log_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#if defined(__wasi__) || defined(_WIN32) /* without locks and signals of POSIX */
#define HAS_LOCKS 0
#else
#include <signal.h>
#define HAS_LOCKS 1
#endif
#ifndef O_BINARY /* Windows alone has files of text */
#define O_BINARY 0
#endif

static bool fail(log_file *f, const char *reason)
{
    fprintf(stderr, "%s: %s", f->path, reason);
    if (f->size > 0) {
        fprintf(stderr, "; the log ends after %lld bytes", (long long)f->size);
    }
    fputc('\n', stderr);
    f->has_failed = true;
    return false;
}

#if !HAS_LOCKS

static bool lock(log_file *f)
{
    (void)f;
    return true;
}

static void ignore_size_limit(void)
{
}

#else

/* The lock goes when the program ends, however it ends. */
static bool lock(log_file *f)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(f->descriptor, F_SETLK, &whole) == 0) {
        return true;
    }
    bool is_in_use = errno == EACCES || errno == EAGAIN;
    return fail(f, is_in_use ? "another program is writing this file" : strerror(errno));
}

/* Beyond its limit of file size a program gets an error instead of a signal. */
static void ignore_size_limit(void)
{
    signal(SIGXFSZ, SIG_IGN);
}

#endif

bool log_file_open(log_file *f, const char *path)
{
    *f = (log_file){.path = path, .descriptor = -1};
    if (path == NULL) {
        return true;
    }
    f->descriptor = open(path, O_WRONLY | O_CREAT | O_BINARY, 0666);
    if (f->descriptor < 0) {
        return fail(f, strerror(errno));
    }
    ignore_size_limit();
    if (!lock(f)) {
        log_file_close(f);
        return false;
    }
    /* Devices and pipes have no length. */
    return ftruncate(f->descriptor, 0) == 0 || errno == EINVAL || fail(f, strerror(errno));
}

bool log_file_write(log_file *f, const uint8_t *bytes, size_t count)
{
    for (size_t done = 0; f->descriptor >= 0 && !f->has_failed && done < count;) {
        ssize_t more = write(f->descriptor, bytes + done, count - done);
        if (more < 0 && errno != EINTR) {
            const char *reason = strerror(errno);
            bool is_cut = ftruncate(f->descriptor, (off_t)f->size) == 0;
            return fail(f, is_cut || done == 0 ? reason : "cannot be written");
        }
        done += more > 0 ? (size_t)more : 0;
    }
    f->size += f->has_failed ? 0 : (int64_t)count;
    return !f->has_failed;
}

void log_file_close(log_file *f)
{
    if (f->path != NULL && f->descriptor >= 0 && close(f->descriptor) != 0 && !f->has_failed) {
        (void)fail(f, strerror(errno)); /* some file systems report a full quota only now */
    }
    f->descriptor = -1;
}
