/* Watching a test fail. */
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "harness/harness.h"

enum { FAILED_AS_IT_MUST = 42 };

static CMUnitTestFunction watched;

/* A crash is no failed assertion: without cmocka's handlers it ends the process, which is seen. */
static void run_watched(void **state)
{
    const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (int i = 0; i < 5; i++) {
        signal(crashes[i], SIG_DFL);
    }
    watched(state);
}

static void run_alone(CMUnitTestFunction test)
{
    const struct CMUnitTest tests[] = {{"alone", run_watched, NULL, NULL, NULL}};
    watched = test;
    if (freopen("/dev/null", "w", stdout) == NULL || freopen("/dev/null", "w", stderr) == NULL) {
        _exit(1);
    }
    /* The child of a sanitizer's process is not asked for its leaks: failing leaves by longjmp. */
    _exit(cmocka_run_group_tests_name("alone", tests, NULL, NULL) == 1 ? FAILED_AS_IT_MUST : 0);
}

void harness_must_fail(CMUnitTestFunction test, const char *name, const char *file, int line)
{
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        run_alone(test);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != FAILED_AS_IT_MUST) {
        print_error("%s passes, or ends otherwise than by a failed assertion\n", name);
        _fail(file, line);
    }
}
