# Windows grows a stack page by page: a function with more than one touches each on its way down. Compilers call this
# with the size in rax, and expect that no register changes. It stands for the one in Zig's library, of 30 kB.
    .globl ___chkstk_ms
___chkstk_ms:
    pushq %rax
    pushq %rcx
    leaq 24(%rsp), %rcx # the caller's stack
touch:
    cmpq $4096, %rax
    jbe last
    subq $4096, %rcx
    orb $0, (%rcx)
    subq $4096, %rax
    jmp touch
last:
    subq %rax, %rcx
    orb $0, (%rcx)
    popq %rcx
    popq %rax
    ret
