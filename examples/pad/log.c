/* The log of the run. */
#include <inttypes.h>

#include "base/error.h"
#include "pad.h"

vbss_result pad_begin_log(pad *p)
{
    vbss_record_config config = vbss_record_config_default();
    char note[48];
    if (p->log == NULL) {
        return VBSS_OK;
    }
    config.hash_interval = 50;
    config.buffer_bytes = 1u << 24;
    config.note = note;
    config.note_bytes = (uint32_t)snprintf(note, sizeof note, "vbss pad seed %" PRIu64, p->seed);
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
