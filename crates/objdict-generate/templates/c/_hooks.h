/* What the application has to say about entries that were asked for with --hook: it defines functions of these names, and the linker
   takes them in the place of those of {{ lower }}.c, which answer {{ upper }}_OK and do nothing else. They are called by {{ lower }}_read() and {{ lower }}_write(), and
   may change any value; other codes than {{ upper }}_OK abort the transfer. A hook that reads its own entry does so from its member of
   {{ lower }}_data_t: {{ lower }}_read() would call it again.

   {{ lower }}_before_read(): the new value is what is read.
   {{ lower }}_after_write(): the new value is in its place; when it is refused, the old one is put back. What else changed stays.

   Where the compiler is not known to {{ lower }}.c, define {{ upper }}_WEAK as what makes a definition weak, or both functions. */
uint32_t {{ lower }}_before_read({{ lower }}_data_t *data, uint16_t index, uint8_t sub);
uint32_t {{ lower }}_after_write({{ lower }}_data_t *data, uint16_t index, uint8_t sub);
