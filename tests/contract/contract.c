#include <string.h>

#include "contract/contract.h"

void contract_add(contract_cases *cases, const char *row, const contract_property *property,
                  const void *argument)
{
    const size_t i = cases->count++;
    if (i >= sizeof cases->cases / sizeof cases->cases[0]) {
        return; /* contract_run_cases fails */
    }
    snprintf(cases->names[i], sizeof cases->names[i], "%s: %s", row, property->name);
    cases->cases[i] = (struct CMUnitTest){
        .name = cases->names[i], .test_func = property->test, .teardown_func = harness_after};
    /* The tests only read it; cmocka's pointer is not const. */
    memcpy(&cases->cases[i].initial_state, &argument, sizeof argument);
}

int contract_run_cases(const char *group, const contract_cases *cases)
{
    if (cases->count > sizeof cases->cases / sizeof cases->cases[0]) {
        fprintf(stderr, "%s: more cases than contract_cases holds\n", group);
        return 1;
    }
    return _cmocka_run_group_tests(group, cases->cases, cases->count, NULL, NULL);
}
