/* What the fuzzers share. A fuzzer is a file with LLVMFuzzerTestOneInput: with libFuzzer (preset fuzz) it
 * runs for as long as one likes, without it a plain driver gives it the corpus (try_corpus.c). */
#ifndef VBSS_TESTS_FUZZ_FUZZ_H
#define VBSS_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/vblast_ss.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Stops the fuzzer where what must hold does not. */
#define MUST(condition) ((condition) ? (void)0 : fuzz_stop(#condition, __FILE__, __LINE__))
_Noreturn void fuzz_stop(const char *condition, const char *file, int line);

/* ---- small_scene.c: a thread, jaws, a needle and a floor in a few nodes */

vbss_result small_scene_create(vbss_context *context, vbss_scene **scene);
/* A drain and a needle. */
vbss_result drain_scene_create(vbss_context *context, vbss_scene **scene);
/* What a host tells the small one before a step; in 40 steps jaws close on the thread and let it go, and so on. */
vbss_result small_scene_drive(vbss_scene *scene, uint32_t step);

/* ---- session_scene.c: thread, needle, drain and two tools, and the numbers of a session over them, with a detector */

vbss_result session_scene_create(vbss_context *context, vbss_scene **scene,
                                 vbss_session_config *session);

/* ---- seal.c: right checksums over wrong bytes, so that what lies behind them is tried */

void seal_snapshot(uint8_t *bytes, size_t count);
/* Lengths keep their place in the row; a snapshot in the log is sealed too. */
void seal_log(uint8_t *bytes, size_t count);

/* ---- configs.c: everything that is made from a struct of the host */

enum { CONFIG_KINDS = 10, CONFIG_ROOM = 4096 };
/* Fills the first bytes with what the kind begins with; how many. */
uint32_t init_config(uint8_t kind, uint8_t *config);
/* Makes it, lives with it for some steps, and saves it. */
void try_config(vbss_context *context, uint8_t kind, void *config);

/* ---- seeds.c: the corpus that the fuzzers begin with */

typedef void (*seed_taker)(void *user, const char *name, const uint8_t *bytes, size_t count);
void make_log_seeds(seed_taker take, void *user);
void make_config_seeds(seed_taker take, void *user);

#endif
