/* The part of the interface of a CANopenNode 1.3 driver that a dictionary needs. */
#ifndef CO_DRIVER_H
#define CO_DRIVER_H

#include <stddef.h>
#include <stdint.h>

#define CO_LITTLE_ENDIAN
typedef unsigned char bool_t;
typedef float float32_t;
typedef char char_t;
typedef unsigned char oChar_t;

#endif
