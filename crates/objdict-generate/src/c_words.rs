//! Reserved words in C sources, for targets whose names keep the spelling of the description.

use std::collections::HashSet;

/// Keywords of C and C++, types of headers, and macros of the standard library.
pub(crate) const RESERVED: &str = "
    auto break case char const continue default do double else enum extern float for goto if inline int
    long register restrict return short signed sizeof static struct switch typedef union unsigned void
    volatile while _Alignas _Alignof _Atomic _Bool _Complex _Generic _Imaginary _Noreturn
    _Static_assert _Thread_local alignas alignof asm constexpr nullptr static_assert thread_local typeof
    and and_eq bitand bitor bool catch char16_t char32_t char8_t class co_await co_return co_yield compl
    concept const_cast consteval constinit decltype delete dynamic_cast explicit export false friend
    mutable namespace new noexcept not not_eq operator or or_eq private protected public
    reinterpret_cast requires static_cast template this throw true try typeid typename using virtual
    wchar_t xor xor_eq
    bool_t int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t float32_t float64_t
    NULL INFINITY NAN HUGE_VAL offsetof assert errno linux unix i386 stdin stdout stderr setjmp
    I EOF BUFSIZ FILENAME_MAX FOPEN_MAX L_tmpnam TMP_MAX SEEK_SET SEEK_CUR SEEK_END _IOFBF _IOLBF _IONBF
    EXIT_SUCCESS EXIT_FAILURE RAND_MAX MB_CUR_MAX MB_LEN_MAX CHAR_BIT CLOCKS_PER_SEC TIME_UTC TRUE FALSE
    EDOM EILSEQ ERANGE ENOENT EINVAL EIO EAGAIN ENOMEM EACCES EBUSY EEXIST EPERM EPIPE EINTR ENODEV ENOSPC
    ETIMEDOUT SIGABRT SIGFPE SIGILL SIGINT SIGSEGV SIGTERM SIGKILL SIGHUP SIGALRM SIGPIPE SIG_DFL SIG_IGN SIG_ERR
    MATH_ERRNO MATH_ERREXCEPT DECIMAL_DIG
";

/// Whether a name cannot be a member or a variable: keywords, and names like macros of stacks or of `stdint.h`.
pub(crate) fn is_reserved(name: &str) -> bool {
    let is_macro =
        name.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_');
    let starts = |starts: &[&str]| starts.iter().any(|start| name.starts_with(start));
    let ends = |ends: &[&str]| ends.iter().any(|end| name.ends_with(end));
    RESERVED.split_ascii_whitespace().any(|word| word == name)
        || name.starts_with("__")
        || starts(&["OD_", "CO_"])
        || is_macro && starts(&["FLT_", "DBL_", "LDBL_", "FP_", "FE_", "LC_", "M_"])
        || is_macro
            && starts(&[
                "INT", "UINT", "SIZE", "PTRDIFF", "SIG", "WCHAR", "WINT", "CHAR", "SCHAR", "UCHAR", "SHRT",
                "USHRT", "LONG", "ULONG", "LLONG", "ULLONG",
            ])
            && ends(&["_MAX", "_MIN", "_C", "_WIDTH"])
}

/// Claims a name, with a suffix if it is already in use.
pub(crate) fn distinct(taken: &mut HashSet<String>, plain: String, suffix: &str) -> String {
    let candidates = (2_u32..).map(|number| format!("{plain}_{suffix}_{number}"));
    let mut candidates = [plain.clone(), format!("{plain}_{suffix}")].into_iter().chain(candidates);
    candidates.find(|candidate| taken.insert(candidate.clone())).unwrap_or(plain) // there are fewer entries than numbers
}

/// Functions of C and POSIX libraries, which a variable at file scope would replace or conflict with.
const FUNCTIONS: &str = "
    abort abs access acos acosh alarm alloca asctime asin asinh atan atan2 atanh atexit atof atoi atol atoll basename bcmp
    bind brk bsearch bzero cabs calloc catan ceil chdir chmod chown clearerr clock close closedir connect copysign cos cosh creat
    ctime daemon difftime dirname div dup dup2 environ erf erfc exec execl execv exit exp exp2 expm1 fabs fclose fcntl fdim feof
    ferror fflush ffs fgetc fgetpos fgets fileno floor fma fmax fmin fmod fopen fork fprintf fputc fputs fread free freopen frexp
    fscanf fseek fsetpos fstat fsync ftell ftruncate fwrite gamma getc getchar getcwd getenv getopt getpid gets gettimeofday
    gmtime htonl htons hypot ilogb index ioctl isalnum isalpha isascii isatty isblank iscntrl isdigit isgraph isinf islower isnan
    isprint ispunct isspace isupper isxdigit j0 j1 jn jrand48 kill labs ldexp ldiv lgamma link listen llabs lldiv llrint llround
    localtime log log10 log1p log2 logb longjmp lrint lround lseek main malloc memchr memcmp memcpy memmove memset mkdir mktime
    mmap modf nan nanosleep nearbyint nextafter nice ntohl ntohs open opendir optarg optind pause perror pipe poll pow printf
    putc putchar putenv puts qsort raise rand random read readlink realloc recv remainder remove remquo rename rewind rindex rint
    rmdir round sbrk scalbln scalbn scanf select send setbuf setenv setlocale setsockopt setvbuf shutdown signal signbit
    significand sin sincos sinh sleep snprintf socket sprintf sqrt srand srandom sscanf stat stpcpy strcasecmp strcat strchr
    strcmp strcoll strcpy strcspn strdup strerror strftime strlen strncat strncmp strncpy strpbrk strrchr strspn strstr strtod
    strtof strtok strtol strtold strtoll strtoul strtoull strxfrm symlink sync sysconf system tan tanh tgamma time times
    timezone tmpfile tmpnam tolower toupper trunc truncate tzname umask uname ungetc unlink usleep utime va_arg va_copy va_end
    va_list va_start vfork vfprintf vprintf vsnprintf vsprintf wait write y0 y1 yn
";

/// Whether a name cannot be a variable at file scope.
pub(crate) fn is_reserved_at_file_scope(name: &str) -> bool {
    is_reserved(name) || FUNCTIONS.split_ascii_whitespace().any(|word| word == name)
}
