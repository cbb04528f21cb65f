/* Codes steps as bits: numbers of inputs as residuals, everything else as flags and varints. */
#include "base/memory.h"
#include "record/step_codec.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The first byte: flags, and the lowest bits of the step's number. */
enum {
    STANDALONE = 1,
    SAME_INPUTS = 2,
    SAME_STEP_SIZE = 4,
    HASHED = 8,
    EVENTS = 16,
    NUMBER_SHIFT = 5
};
enum { KIND_BITS = 4, MAX_CHANNELS = 32, MAX_NUMBERS = 12, EVENT_WORDS = 4 };

/* History of the numbers of one kind of input to one body or attachment. */
typedef struct log_channel {
    uint32_t kind, key[2];
    log_predictor numbers[MAX_NUMBERS];
} log_channel;

struct log_coder {
    bool needs_standalone; /* the next step must not depend on earlier ones */
    double h;              /* length of the last step, s */
    uint32_t input_count, input_capacity;
    uint8_t *kinds; /* kind, words and channel of each input of the last step */
    uint32_t (*words)[4];
    uint8_t *channel_indices;
    uint32_t channel_count, oldest; /* oldest: replaced when there is no room */
    log_channel channels[MAX_CHANNELS];
};

static const log_predictor empty_predictors[MAX_NUMBERS];

/* ---- memory and history */

static void list_coder_arrays(log_coder *c, vbss_array arrays[3])
{
    arrays[0] = (vbss_array){&c->kinds, c->input_capacity, sizeof *c->kinds};
    arrays[1] = (vbss_array){&c->words, c->input_capacity, sizeof *c->words};
    arrays[2] = (vbss_array){&c->channel_indices, c->input_capacity, sizeof *c->channel_indices};
}

vbss_result vbss_log_make_coder(vbss_context *context, uint32_t input_capacity, log_coder **coder)
{
    vbss_array arrays[3];
    log_coder *c = vbss_allocate(context, 1, sizeof *c, "coder of a log");
    *coder = c;
    if (c == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    c->input_capacity = input_capacity;
    vbss_log_reset_coder(c);
    list_coder_arrays(c, arrays);
    return vbss_allocate_arrays(context, arrays, 3, "coder of a log");
}

void vbss_log_free_coder(vbss_context *context, log_coder *coder)
{
    vbss_array arrays[3];
    if (coder == NULL) {
        return;
    }
    list_coder_arrays(coder, arrays);
    vbss_release_arrays(context, arrays, 3);
    vbss_release(context, coder, 1, sizeof *coder);
}

static void clear_history(log_coder *c)
{
    c->h = 0.0;
    c->input_count = c->channel_count = c->oldest = 0;
}

void vbss_log_reset_coder(log_coder *coder)
{
    clear_history(coder);
    coder->needs_standalone = true;
}

/* ---- channels */

/* Each attachment has a history of its own. In other inputs the second word is not an object. */
static void key_of(const vbss_record_input *input, uint32_t key[2])
{
    key[0] = input->words[0];
    key[1] = input->kind == VBSS_RECORD_INPUT_ATTACHMENT_TARGET ||
                     input->kind == VBSS_RECORD_INPUT_DRAIN_TARGET
                 ? input->words[1]
                 : 0;
}

/* Index of the channel, or MAX_CHANNELS if there is none. */
static uint32_t find_channel(const log_coder *c, const vbss_record_input *input)
{
    uint32_t key[2], i = 0;
    key_of(input, key);
    while (i < c->channel_count &&
           (c->channels[i].kind != (uint32_t)input->kind || c->channels[i].key[0] != key[0] ||
            c->channels[i].key[1] != key[1])) {
        i++;
    }
    return i < c->channel_count ? i : MAX_CHANNELS;
}

static const log_predictor *predictors_of(const log_coder *c, bool same, uint32_t i,
                                          const vbss_record_input *input)
{
    uint32_t channel_index = same ? c->channel_indices[i] : find_channel(c, input);
    return channel_index < MAX_CHANNELS ? c->channels[channel_index].numbers : empty_predictors;
}

static uint32_t make_channel(log_coder *c, const vbss_record_input *input)
{
    uint32_t channel_index =
        c->channel_count < MAX_CHANNELS ? c->channel_count++ : c->oldest++ % MAX_CHANNELS;
    memset(&c->channels[channel_index], 0, sizeof c->channels[channel_index]);
    c->channels[channel_index].kind = (uint32_t)input->kind;
    key_of(input, c->channels[channel_index].key);
    return channel_index;
}

static void update_history(log_coder *c, const log_step *step, bool same)
{
    for (uint32_t i = 0; i < step->input_count; i++) {
        const vbss_record_input *input = &step->inputs[i];
        uint32_t channel_index = same ? c->channel_indices[i] : find_channel(c, input);
        channel_index = channel_index < MAX_CHANNELS ? channel_index : make_channel(c, input);
        for (uint32_t n = 0; n < vbss_log_input_shapes[input->kind].numbers; n++) {
            vbss_log_update_predictor(&c->channels[channel_index].numbers[n], input->numbers[n]);
        }
        c->kinds[i] = (uint8_t)input->kind;
        memcpy(c->words[i], input->words, sizeof c->words[i]);
        c->channel_indices[i] = (uint8_t)channel_index;
    }
    c->input_count = step->input_count;
    c->h = step->h;
    c->needs_standalone = false;
}

/* ---- writing */

static bool has_same_inputs(const log_coder *c, const log_step *step)
{
    bool same = step->input_count == c->input_count;
    for (uint32_t i = 0; same && i < step->input_count; i++) {
        uint8_t kind = step->kinds[i];
        same = kind == c->kinds[i] &&
               memcmp(step->inputs[i].words, c->words[i],
                      vbss_log_input_shapes[kind].words * sizeof c->words[i][0]) == 0;
    }
    return same;
}

static uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static void put_input_list(log_bits *bits, const log_step *step)
{
    vbss_log_put_varint(bits, step->input_count);
    for (uint32_t i = 0; i < step->input_count; i++) {
        vbss_log_put_bits(bits, step->kinds[i], KIND_BITS);
        for (uint32_t n = 0; n < vbss_log_input_shapes[step->kinds[i]].words; n++) {
            vbss_log_put_varint(bits, step->inputs[i].words[n]);
        }
    }
}

static void put_events(log_bits *bits, const log_step *step)
{
    vbss_log_put_varint(bits, step->event_count);
    for (uint32_t i = 0; i < step->event_count; i++) {
        for (uint32_t n = 0; n < EVENT_WORDS; n++) {
            vbss_log_put_varint(bits, step->events[i][n]);
        }
    }
}

bool vbss_log_can_encode(const log_step *step)
{
    bool can = true;
    for (uint32_t i = 0; i < step->input_count; i++) {
        can = can && step->kinds[i] < 1u << KIND_BITS;
    }
    return can;
}

size_t vbss_log_max_coded_bytes(const log_step *step, uint32_t event_count)
{
    const size_t fixed = 1 + 8 + 8, count = LOG_MAX_VARINT_BITS / 8;
    size_t bits = 7;
    for (uint32_t i = 0; i < step->input_count; i++) {
        const log_input_shape shape = vbss_log_input_shapes[step->kinds[i]];
        bits += KIND_BITS + (size_t)shape.words * LOG_MAX_VARINT_BITS +
                (size_t)shape.numbers * LOG_MAX_NUMBER_BITS;
    }
    bits += (size_t)event_count * EVENT_WORDS * LOG_MAX_VARINT_BITS;
    return fixed + 2 * count + bits / 8;
}

size_t vbss_log_encode(log_coder *coder, const log_step *step, uint8_t *bytes, size_t capacity)
{
    log_bits bits = {.count = capacity};
    const bool same = has_same_inputs(coder, step),
               same_step_size = bits_of(step->h) == bits_of(coder->h);
    uint32_t flags = (coder->needs_standalone ? STANDALONE : 0u) | (same ? SAME_INPUTS : 0u) |
                     (same_step_size ? SAME_STEP_SIZE : 0u) | (step->has_hash != 0 ? HASHED : 0u) |
                     (step->event_count > 0 ? EVENTS : 0u);
    bits.out = bytes;
    vbss_log_put_bits(&bits, flags, NUMBER_SHIFT);
    vbss_log_put_bits(&bits, step->number, 8 - NUMBER_SHIFT);
    if (!same_step_size) {
        vbss_log_put_bits(&bits, bits_of(step->h), 64);
    }
    if (step->has_hash != 0) {
        vbss_log_put_bits(&bits, step->hash, 64);
    }
    if (!same) {
        put_input_list(&bits, step);
    }
    for (uint32_t i = 0; i < step->input_count; i++) {
        const log_predictor *predictor = predictors_of(coder, same, i, &step->inputs[i]);
        for (uint32_t n = 0; n < vbss_log_input_shapes[step->kinds[i]].numbers; n++) {
            vbss_log_put_number(&bits, &predictor[n], step->inputs[i].numbers[n]);
        }
    }
    if (step->event_count > 0) {
        put_events(&bits, step);
    }
    update_history(coder, step, same);
    return log_bits_bytes(&bits);
}

/* ---- reading */

static void set_input_kind(log_step *step, uint32_t i, uint32_t kind)
{
    vbss_record_input *input = &step->inputs[i];
    step->kinds[i] = (uint8_t)kind;
    input->kind = (vbss_record_input_kind)kind;
    input->word_count = vbss_log_input_shapes[kind].words;
    input->number_count = vbss_log_input_shapes[kind].numbers;
}

static const char *get_input_list(log_bits *bits, log_step *step)
{
    uint32_t count = vbss_log_get_varint(bits);
    if (count > step->input_capacity) {
        return "more inputs than the log says there can be";
    }
    step->input_count = count;
    for (uint32_t i = 0; i < count && !bits->overrun; i++) {
        uint32_t kind = (uint32_t)vbss_log_get_bits(bits, KIND_BITS);
        if (kind == 0 || kind >= LOG_INPUT_KINDS) {
            return "no such input";
        }
        set_input_kind(step, i, kind);
        for (uint32_t n = 0; n < step->inputs[i].word_count; n++) {
            step->inputs[i].words[n] = vbss_log_get_varint(bits);
        }
    }
    return NULL;
}

static void repeat_input_list(const log_coder *c, log_step *step)
{
    step->input_count = c->input_count;
    for (uint32_t i = 0; i < c->input_count; i++) {
        set_input_kind(step, i, c->kinds[i]);
        memcpy(step->inputs[i].words, c->words[i], sizeof c->words[i]);
    }
}

static const char *get_numbers(log_bits *bits, const log_coder *c, bool same, log_step *step)
{
    for (uint32_t i = 0; i < step->input_count && !bits->overrun; i++) {
        const log_predictor *predictor = predictors_of(c, same, i, &step->inputs[i]);
        for (uint32_t n = 0; n < step->inputs[i].number_count; n++) {
            double x = vbss_log_get_number(bits, &predictor[n]);
            if (!(fabs(x) <= DBL_MAX)) {
                return "a number is not finite";
            }
            step->inputs[i].numbers[n] = x;
        }
    }
    return NULL;
}

static const char *get_events(log_bits *bits, log_step *step)
{
    uint32_t count = vbss_log_get_varint(bits);
    if (count == 0 || count > step->event_capacity) {
        return "no event, or more than the log says there can be";
    }
    step->event_count = count;
    for (uint32_t i = 0; i < count && !bits->overrun; i++) {
        for (uint32_t n = 0; n < EVENT_WORDS; n++) {
            step->events[i][n] = vbss_log_get_varint(bits);
        }
    }
    return NULL;
}

static const char *get_step_header(log_bits *bits, log_coder *c, uint64_t steps_before,
                                   log_step *step, uint32_t *flags)
{
    *flags = (uint32_t)vbss_log_get_bits(bits, NUMBER_SHIFT);
    uint64_t number = vbss_log_get_bits(bits, 8 - NUMBER_SHIFT);
    step->number = steps_before + 1;
    if (number != step->number % (1u << (8 - NUMBER_SHIFT))) {
        return "another step was expected";
    }
    if ((*flags & STANDALONE) != 0) {
        clear_history(c);
    } else if (c->needs_standalone) {
        return "a step that stands alone was expected";
    }
    uint64_t h = (*flags & SAME_STEP_SIZE) != 0 ? bits_of(c->h) : vbss_log_get_bits(bits, 64);
    memcpy(&step->h, &h, sizeof h);
    step->has_hash = (*flags & HASHED) != 0;
    step->hash = step->has_hash != 0 ? vbss_log_get_bits(bits, 64) : 0;
    return fabs(step->h) <= DBL_MAX ? NULL : "a number is not finite";
}

const char *vbss_log_decode(log_coder *coder, uint64_t steps_before, const uint8_t *bytes,
                            size_t count, log_step *step)
{
    log_bits bits = {.in = bytes, .count = count};
    uint32_t flags;
    const char *problem = get_step_header(&bits, coder, steps_before, step, &flags);
    const bool same = (flags & SAME_INPUTS) != 0;
    step->event_count = 0;
    if (problem == NULL && same) {
        repeat_input_list(coder, step);
    } else if (problem == NULL) {
        problem = get_input_list(&bits, step);
    }
    if (problem == NULL) {
        problem = get_numbers(&bits, coder, same, step);
    }
    if (problem == NULL && (flags & EVENTS) != 0) {
        problem = get_events(&bits, step);
    }
    if (problem == NULL && !vbss_log_bits_are_complete(&bits)) {
        problem = "the step does not end where its record does";
    }
    if (problem == NULL) {
        update_history(coder, step, same);
    }
    return problem;
}
