/* Golden hashes: kept in a text file that a person can read and a diff can show. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"

static FILE *open_golden(const char *name, const char *mode)
{
    char path[1024];
    int length = snprintf(path, sizeof path, "%s/%s.txt", VBSS_GOLDEN_DIR, name);
    assert_true(length > 0 && (size_t)length < sizeof path);
    FILE *file = fopen(path, mode);
    if (file == NULL) {
        fail_msg("cannot open tests/golden/%s.txt", name);
    }
    return file;
}

static void write_golden(const char *name, const uint64_t *hashes, size_t count)
{
    FILE *file = open_golden(name, "w");
    for (size_t i = 0; i < count; i++) {
        fprintf(file, "%zu %016" PRIx64 "\n", i, hashes[i]);
    }
    fclose(file);
}

size_t harness_first_difference(const uint64_t *a, const uint64_t *b, size_t count)
{
    size_t i = 0;
    while (i < count && a[i] == b[i]) {
        i++;
    }
    return i;
}

void harness_golden(const char *name, const uint64_t *hashes, size_t count)
{
    const char *update = getenv("VBSS_UPDATE_GOLDEN");
    if (update != NULL && strcmp(update, "1") == 0) {
        write_golden(name, hashes, count);
        return;
    }
    uint64_t *golden = calloc(count + 1, sizeof *golden);
    assert_non_null(golden);
    FILE *file = open_golden(name, "r");
    size_t found = 0, index = 0;
    uint64_t hash = 0;
    /* One line too many is enough to see that the counts differ. */
    while (found <= count && fscanf(file, "%zu %" SCNx64, &index, &hash) == 2 && index == found) {
        golden[found++] = hash;
    }
    fclose(file);
    size_t first = harness_first_difference(golden, hashes, found < count ? found : count);
    uint64_t want = first < found ? golden[first] : 0;
    free(golden);
    if (first < count && first < found) {
        fail_msg("%s: first difference at index %zu: %016" PRIx64 ", golden %016" PRIx64, name,
                 first, hashes[first], want);
    }
    if (found != count) {
        fail_msg("%s: %zu hashes, the golden file holds %s%zu", name, count,
                 found > count ? "at least " : "", found);
    }
}
