/* Hooks of the application for the entries selected with --hook: the application defines functions with these names, which replace
   those of {{ lower }}.c, which only return {{ upper }}_OK. {{ lower }}_read() and {{ lower }}_write() call them. Hooks may change
   any value; codes other than {{ upper }}_OK abort the transfer. A hook must read its own entry from its member of {{ lower }}_data_t,
   because {{ lower }}_read() would call the hook again.

   If {{ lower }}.c does not support the compiler, define {{ upper }}_WEAK as its attribute for weak definitions, or define both functions. */
/** Called before an entry is read; may change its value. */
uint32_t {{ lower }}_before_read({{ lower }}_data_t *data, uint16_t index, uint8_t sub);
/** Called when an entry has its new value; if the hook rejects it, the old one is restored. Other changes remain. */
uint32_t {{ lower }}_after_write({{ lower }}_data_t *data, uint16_t index, uint8_t sub);
