/* What the processor has, of what the system keeps the registers. The compilers' own answer is not used: that of Zig's
 * library is no to everything. */
#include <cpuid.h>
enum { HAS_AVX2 = 1, HAS_AVX512 = 2 };
static int asked_processor(void)
{
    const unsigned wide = bit_AVX512F | bit_AVX512DQ | bit_AVX512VL;
    unsigned a, b, c, d, kept, high;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & bit_OSXSAVE) || !(c & bit_FMA)) return 0;
    __asm__("xgetbv" : "=a"(kept), "=d"(high) : "c"(0));
    if ((kept & 0x06) != 0x06 || !__get_cpuid_count(7, 0, &a, &b, &c, &d) || !(b & bit_AVX2)) return 0;
    return HAS_AVX2 | ((kept & 0xe0) == 0xe0 && (b & wide) == wide ? HAS_AVX512 : 0);
}
/* Asked once: under a hypervisor each question takes microseconds. */
static int processor(void)
{
    static int answer = -1;
    if (answer < 0) answer = asked_processor();
    return answer;
}
#define RUNS_avx512 (processor() & HAS_AVX512)
#define RUNS_avx2 (processor() & HAS_AVX2)
