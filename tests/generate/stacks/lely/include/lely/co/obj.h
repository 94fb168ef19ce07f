/*
 * The part of the interface of Lely core 2.4 that has the library call functions of the application.
 */
#ifndef LELY_CO_OBJ_H
#define LELY_CO_OBJ_H

#include <lely/co/sdev.h>

struct co_sdo_req;
typedef struct co_sub co_sub_t;
typedef co_unsigned32_t co_sub_dn_ind_t(co_sub_t *sub, struct co_sdo_req *req, void *data);
typedef co_unsigned32_t co_sub_up_ind_t(const co_sub_t *sub, struct co_sdo_req *req, void *data);

void co_sub_set_dn_ind(co_sub_t *sub, co_sub_dn_ind_t *ind, void *data);
void co_sub_set_up_ind(co_sub_t *sub, co_sub_up_ind_t *ind, void *data);

#endif
