/* The log of the run, and its replay. */
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "pad.h"

static const char note[] = "vbss pad seed 0";

vbss_result pad_begin_log(pad *p)
{
    vbss_record_config config = vbss_record_config_default();
    if (p->log == NULL) {
        return VBSS_OK;
    }
    config.hash_interval = 50;
    config.buffer_bytes = 1u << 24;
    config.note = note;
    config.note_bytes = sizeof note - 1;
    VBSS_TRY(vbss_record_create(p->scene, &config, &p->record));
    VBSS_TRY(vbss_scene_set_recorder(p->scene, p->record));
    return pad_write_log(p);
}

vbss_result pad_write_log(pad *p)
{
    const uint8_t *bytes;
    uint64_t count;
    if (p->record == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_record_take(p->record, &bytes, &count));
    return fwrite(bytes, 1, (size_t)count, p->log) == count ? VBSS_OK : VBSS_ERROR_TRUNCATED;
}

vbss_result pad_end_log(pad *p)
{
    VBSS_TRY(p->record != NULL ? vbss_record_end(p->record) : VBSS_OK);
    return pad_write_log(p);
}

static uint8_t *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    if (file != NULL && fseek(file, 0, SEEK_END) == 0 && ftell(file) > 0) {
        *size = (size_t)ftell(file);
        rewind(file);
        bytes = malloc(*size);
        if (bytes != NULL && fread(bytes, 1, *size, file) != *size) {
            free(bytes);
            bytes = NULL;
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return bytes;
}

static vbss_result play(vbss_context *context, const uint8_t *bytes, size_t size, uint64_t *steps,
                        uint64_t *hash)
{
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_replay_report report = {0};
    VBSS_TRY(vbss_replay_create(context, bytes, size, &replay));
    VBSS_TRY(vbss_replay_load_scene(replay, &scene));
    do {
        VBSS_TRY(vbss_replay_step(replay, &report, sizeof report));
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    *steps = report.outcome == VBSS_REPLAY_OUTCOME_ENDED ? report.step : 0;
    return vbss_scene_get_hash(scene, hash);
}

vbss_result pad_replay(const char *path, uint64_t *steps, uint64_t *hash)
{
    size_t size = 0;
    uint8_t *bytes = read_file(path, &size);
    vbss_context *context;
    *steps = *hash = 0;
    vbss_result result = bytes == NULL ? VBSS_ERROR_TRUNCATED : vbss_context_create(NULL, &context);
    if (result == VBSS_OK) {
        result = play(context, bytes, size, steps, hash);
        (void)vbss_context_destroy(context);
    }
    free(bytes);
    return result;
}
