#include "fuzz/scenes/findings.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

static const char *const names[FUZZ_CHECKS] = {
    "crash",       "hang",       "stalled", "refused-but-changed", "query-changes",
    "twin-status", "twin-state", "restore", "not-finite",          "setup"};

fuzz_findings *fuzz_share_findings(void)
{
    void *memory = mmap(NULL, sizeof(fuzz_findings), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? NULL : memory;
}

static fuzz_row *find_row(fuzz_findings *f, fuzz_check check)
{
    for (uint32_t i = 0; i < f->row_count; i++) {
        fuzz_row *row = &f->rows[i];
        if (row->check == check && strcmp(row->function, f->function) == 0) {
            return row;
        }
    }
    if (f->row_count == FUZZ_MAX_ROWS) {
        return NULL;
    }
    fuzz_row *row = &f->rows[f->row_count++];
    *row = (fuzz_row){.check = check, .call = UINT32_MAX};
    memcpy(row->function, f->function, sizeof row->function);
    return row;
}

void fuzz_record(fuzz_findings *f, fuzz_check check, const char *detail)
{
    fuzz_row *row = find_row(f, check);
    f->failures++;
    if (row != NULL) {
        row->count++;
        if (f->call < row->call) {
            row->scene = f->scene;
            row->call = f->call;
        }
    }
    printf("FAILED seed %llu scene %llu call %u: %s in %s: %s\n", (unsigned long long)f->seed,
           (unsigned long long)f->scene, f->call, names[check], f->function, detail);
    fflush(stdout);
}

void fuzz_print_summary(const fuzz_findings *f)
{
    for (uint32_t i = 0; i < f->row_count; i++) {
        const fuzz_row *row = &f->rows[i];
        printf("%6llu x %-20s %-28s shortest: --seed %llu --scene %llu --calls %u\n",
               (unsigned long long)row->count, names[row->check], row->function,
               (unsigned long long)f->seed, (unsigned long long)row->scene,
               row->call > 0 ? row->call : 1);
    }
    printf("%llu scenes, %llu calls: %llu refused, %llu steps suspended, %llu with a grasp, %llu "
           "with a hole, %llu "
           "cuts; slowest call %.3f s; %llu failures\n",
           (unsigned long long)f->scenes, (unsigned long long)f->calls,
           (unsigned long long)f->refused, (unsigned long long)f->suspended,
           (unsigned long long)f->grasps, (unsigned long long)f->holes, (unsigned long long)f->cuts,
           f->slowest_call, (unsigned long long)f->failures);
}
