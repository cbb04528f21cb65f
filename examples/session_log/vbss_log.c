/* Looks at a session log and prints it as text:
 *
 *     vbss-log info|validate|csv|json FILE
 *
 * Exits 0 for a log that is whole, 1 for one that is cut off or damaged, of which it prints what is good; 2 where it could
 * not begin. */
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "session_log/export.h"

typedef vbss_result (*command)(FILE *out, vbss_context *context, const log_file *log);

static const struct {
    const char *name;
    command run;
} commands[] = {
    {"info", print_info},
    {"validate", print_faults},
    {"csv", print_csv},
    {"json", print_json},
};

static int read_whole(const char *path, log_file *log)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        return 0;
    }
    long size = ftell(file);
    log->bytes = size < 0 ? NULL : malloc((size_t)size + 1);
    rewind(file);
    log->count = log->bytes == NULL ? 0 : fread(log->bytes, 1, (size_t)size, file);
    return fclose(file) == 0 && log->bytes != NULL && log->count == (uint64_t)size;
}

static int run(command print, const log_file *log)
{
    vbss_context *context;
    const char *text;
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return 2;
    }
    vbss_result result = print(stdout, context, log);
    if (result != VBSS_OK && vbss_context_get_last_error(context, NULL, &text) == VBSS_OK) {
        fprintf(stderr, "%s%s%s\n", vbss_result_name(result), text[0] != '\0' ? ": " : "", text);
    }
    vbss_context_destroy(context);
    return result == VBSS_OK ? 0 : 1;
}

int main(int argc, char **argv)
{
    use_decimal_point();
    log_file log = {NULL, 0};
    for (size_t i = 0; argc == 3 && i < sizeof commands / sizeof commands[0]; i++) {
        if (strcmp(argv[1], commands[i].name) == 0) {
            if (!read_whole(argv[2], &log)) {
                fprintf(stderr, "%s cannot be read\n", argv[2]);
                return 2;
            }
            int code = run(commands[i].run, &log);
            free(log.bytes);
            return fflush(stdout) == 0 ? code : 2;
        }
    }
    fprintf(stderr, "vbss-log info|validate|csv|json FILE\n");
    return 2;
}
