/* The contract of a body: properties that every kind of body keeps, whatever it computes. A file test_<kind>.c has the tables
 * of one kind. Each property runs as one cmocka case for each row; the case is named "<row>: <property>". */
#ifndef VBSS_TESTS_CONTRACT_H
#define VBSS_TESTS_CONTRACT_H

#include "harness/harness.h"

/* ---- scripted runs (run_contract.c) */

enum { CONTRACT_SAVES = 12, CONTRACT_DAMAGES = 2 };

/* The script of a body depends on the body's state alone, so that a restored body continues alike. A length of 0 leaves a
 * property out. */
typedef struct contract_run {
    const char *name;
    harness_body body;
    size_t saves[CONTRACT_SAVES]; /* steps after which the body is saved, ascending */
    size_t save_count;
    size_t continued;                 /* steps that are compared after each restore */
    size_t damages[CONTRACT_DAMAGES]; /* steps after which a snapshot is damaged */
    size_t damage_count;
    size_t quiet;    /* steps that may not allocate */
    size_t repeated; /* steps that two runs must share bit by bit */
    /* Asserts that the script reaches the events that the saves are about; NULL: no such case. */
    void (*covers)(const struct contract_run *run);
    /* Writes impossible value `which` into the body; NULL: no such case. */
    void (*spoil)(void *handle, uint32_t which);
    uint32_t spoil_count;
    size_t spoil_at; /* steps before that */
} contract_run;

int contract_check_runs(const char *group, const contract_run *runs, size_t count);

/* ---- objects: creation, handles, structs, memory (object_contract.c) */

/* A struct that is filled by the library. */
typedef struct contract_output {
    uint32_t size;     /* today's */
    uint32_t older[3]; /* sizes of earlier versions that are still filled; 0: none */
    vbss_result (*write)(void *handle, void *out, uint32_t size);
} contract_output;

/* A call on a handle, all other arguments valid. */
typedef struct contract_call {
    harness_handle_call call;
    bool edits;         /* it changes the object: rejected inside callbacks */
    bool is_one_time;   /* it is not repeated after the callback */
    vbss_result result; /* outside callbacks */
} contract_call;

typedef struct contract_attempt {
    harness_attempt run;
    void *(*argument)(void); /* of `run`; NULL: none */
} contract_attempt;

enum { CONTRACT_CONFIGS = 2, CONTRACT_OUTPUTS = 5, CONTRACT_CALLS = 16, CONTRACT_ATTEMPTS = 8 };

typedef struct contract_object {
    const char *name;
    harness_config configs[CONTRACT_CONFIGS]; /* the object's own first */
    /* An object on which every call works, in the order of `calls`. */
    vbss_result (*create)(vbss_context *context, void **handle);
    /* From a given configuration, or from the default one if NULL. */
    vbss_result (*create_from)(vbss_context *context, const void *config, void **handle);
    const void *(*config)(void); /* a valid one */
    vbss_result null_config;     /* of create_from without a configuration */
    vbss_result (*destroy)(void *handle);
    vbss_result (*reject)(void *handle); /* a call with a value out of range */
    vbss_result (*hash)(void *handle, uint64_t *hash);
    contract_output outputs[CONTRACT_OUTPUTS];
    contract_call calls[CONTRACT_CALLS];
    const vbss_kind
        *owned_kind; /* of objects that reject every edit while a scene owns them; else NULL */
    contract_attempt attempts[CONTRACT_ATTEMPTS];
    /* Creates and destroys in cycle i; NULL: no such case. */
    vbss_result (*cycle)(vbss_context *context, uint32_t i);
    uint32_t cycles;
} contract_object;

int contract_check_object(const char *group, const contract_object *object);

/* ---- snapshots through the public interface (snapshot_contract.c) */

/* A number or a choice of a configuration that a snapshot must match. */
typedef struct contract_field {
    size_t offset;
    size_t count;  /* consecutive doubles; 0: one uint32_t */
    double factor; /* of a double that is not 0. An uint32_t: added to it */
} contract_field;

enum { CONTRACT_FIELDS = 32 };

typedef struct contract_snapshot {
    const char *name;
    const vbss_kind *kind;
    void (*config)(void *config); /* fills one */
    size_t config_size;
    vbss_result (*create)(vbss_context *context, const void *config, void **handle);
    vbss_result (*destroy)(void *handle);
    /* NULL where the interface has no such functions. */
    vbss_result (*save)(void *handle, void *bytes, uint64_t capacity, uint64_t *written);
    vbss_result (*restore)(void *handle, const void *bytes, uint64_t count);
    contract_field fields[CONTRACT_FIELDS];
    void (*reserve_more)(void *config); /* changes what a snapshot need not match; NULL: nothing */
    vbss_result (*step)(void *handle);  /* before the restore into that; NULL: none */
} contract_snapshot;

int contract_check_snapshot(const char *group, const contract_snapshot *snapshot);

/* ---- membership of a scene (member_contract.c) */

typedef struct contract_member {
    const char *name;
    /* An object of that method, at place 0, 1, ... apart from the others; it is not in a scene. */
    vbss_result (*create)(vbss_context *context, uint32_t place, vbss_method method, void **handle);
    vbss_result (*destroy)(void *handle);
    vbss_result (*discard)(void *handle);
    vbss_result (*step)(void *handle);
    vbss_result (*save)(void *handle, void *bytes, uint64_t capacity, uint64_t *written);
    vbss_result (*restore)(void *handle, const void *bytes, uint64_t count);
    vbss_result (*hash)(void *handle, uint64_t *hash);
    vbss_result (*add)(vbss_scene *scene, void *handle, uint32_t *body);
    vbss_result (*edit)(
        void *handle); /* is rejected while a scene owns the object; NULL: no such call */
    /* Calls that work in and outside a scene, and what shows whether a scene owns the object; NULL: none. */
    void (*use)(void *handle, bool owned);
    /* Gives the scene capacity for that many, in its k-th kind of capacity. */
    void (*limit)(vbss_scene_config *config, uint32_t count, uint32_t kind);
    uint32_t limit_kinds;
    uint64_t add_allocations; /* the fewest that adding one makes */
} contract_member;

int contract_check_member(const char *group, const contract_member *member);

/* ---- running (contract.c) */

typedef struct contract_property {
    const char *name;
    CMUnitTestFunction test; /* *state is the row */
} contract_property;

/* The cases of one group, in the order in which they are added. */
typedef struct contract_cases {
    struct CMUnitTest cases[192];
    char names[192][120];
    size_t count;
} contract_cases;
void contract_add(contract_cases *cases, const char *row, const contract_property *property,
                  const void *argument);
int contract_run_cases(const char *group, const contract_cases *cases);

#endif
