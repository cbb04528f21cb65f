#define _POSIX_C_SOURCE 200809L
#include "harness/environment.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The build says what it was told to do (bench/CMakeLists.txt). */
#if !defined(BENCH_FLAGS)
#define BENCH_FLAGS ""
#endif

#if defined(__clang__)
#define COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "unknown"
#endif

/* The first line of a file, without its newline. */
static void read_line(const char *path, char *line, int capacity)
{
    FILE *file = fopen(path, "r");
    line[0] = '\0';
    if (file == NULL) {
        return;
    }
    if (fgets(line, capacity, file) == NULL) {
        line[0] = '\0';
    }
    line[strcspn(line, "\n")] = '\0';
    fclose(file);
}

static void read_cpu(bench_environment *environment)
{
    char line[512];
    FILE *file = fopen("/proc/cpuinfo", "r");
    if (file == NULL) {
        return;
    }
    while (fgets(line, sizeof line, file) != NULL) {
        const char *value = strchr(line, ':');
        if (value == NULL) {
            continue;
        }
        value += strspn(value, ": \t");
        if (environment->cpu_model[0] == '\0' && strncmp(line, "model name", 10) == 0) {
            snprintf(environment->cpu_model, sizeof environment->cpu_model, "%.*s",
                     (int)strcspn(value, "\n"), value);
        } else if (!(environment->mhz > 0.0) && strncmp(line, "cpu MHz", 7) == 0) {
            environment->mhz = strtod(value, NULL);
        }
    }
    fclose(file);
}

/* Number of processors in a list such as "0-3,8,10-11". */
static unsigned count_list(const char *list)
{
    unsigned count = 0;
    while (*list != '\0') {
        char *end = NULL;
        unsigned long first = strtoul(list, &end, 10), last = first;
        if (end == list) {
            break;
        }
        if (*end == '-') {
            last = strtoul(end + 1, &end, 10);
        }
        count += last >= first ? (unsigned)(last - first + 1) : 0;
        list = *end == ',' ? end + 1 : end;
    }
    return count;
}

static void read_caches(bench_environment *environment)
{
    for (unsigned i = 0; i < BENCH_MAX_CACHES; i++) {
        static const char *const names[] = {"level", "type", "size", "shared_cpu_list"};
        char lines[4][64];
        for (size_t k = 0; k < 4; k++) {
            char path[128];
            snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu0/cache/index%u/%s", i,
                     names[k]);
            read_line(path, lines[k], sizeof lines[k]);
        }
        if (lines[0][0] == '\0') {
            return;
        }
        bench_cache *cache = &environment->caches[environment->cache_count++];
        char *unit = NULL;
        cache->level = (unsigned)strtoul(lines[0], NULL, 10);
        snprintf(cache->type, sizeof cache->type, "%.23s", lines[1]);
        cache->size = strtoul(lines[2], &unit, 10);
        cache->size *= *unit == 'K' ? 1024ul : *unit == 'M' ? 1024ul * 1024ul : 1ul;
        cache->sharing = count_list(lines[3]);
    }
}

void bench_copy_without_paths(char *to, size_t capacity, const char *text)
{
    size_t used = 0;
    while (*text != '\0') {
        text += strspn(text, " \t\n");
        size_t length = strcspn(text, " \t\n");
        if (length > 0 && memchr(text, '/', length) == NULL && used + length + 2 <= capacity) {
            if (used > 0) {
                to[used++] = ' ';
            }
            memcpy(to + used, text, length);
            used += length;
        }
        text += length;
    }
    to[used] = '\0';
}

void bench_read_environment(bench_environment *environment)
{
    memset(environment, 0, sizeof *environment);
    time_t now = time(NULL);
    struct tm utc;
    if (gmtime_r(&now, &utc) != NULL) {
        strftime(environment->date, sizeof environment->date, "%Y-%m-%dT%H:%M:%S+00:00", &utc);
    }
    read_cpu(environment);
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    environment->cpu_count = online > 0 ? (unsigned)online : 0;
    char load[128];
    read_line("/proc/loadavg", load, sizeof load);
    char *next = load;
    for (size_t i = 0; i < 3; i++) {
        environment->load[i] = strtod(next, &next);
    }
    read_caches(environment);
    bench_copy_without_paths(environment->compiler, sizeof environment->compiler, COMPILER);
    bench_copy_without_paths(environment->flags, sizeof environment->flags, BENCH_FLAGS);
}
