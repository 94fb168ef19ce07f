/*
 * {{ head.made_by }}; do not edit.
 *
 * The static device {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for Lely core 2.4.
 */
#ifndef {{ head.upper }}_SDEV_H
#define {{ head.upper }}_SDEV_H

#include <lely/co/sdev.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The argument of co_dev_create_from_sdev(). */
extern const struct co_sdev {{ head.lower }}_sdev;

#if LELY_NO_MALLOC
/* In place of co_dev_create_from_sdev(): makes the one device in static memory; NULL for an invalid node-ID. Call it once. */
co_dev_t *{{ head.lower }}_create(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
