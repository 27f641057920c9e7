#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace brouwer {

namespace detail {
// The instructions that the compilers' vector types have no operator for, by width. Overloads exist where the target
// has them; everything else goes lane by lane.
void vector_sqrt();
void vector_max();
void vector_min();
void vector_fused_add();
void vector_fused_subtract();
#if defined(__SSE2__)
inline __m128d vector_sqrt(__m128d a) { return _mm_sqrt_pd(a); }
inline __m128d vector_max(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
inline __m128d vector_min(__m128d a, __m128d b) { return _mm_min_pd(a, b); }
inline __m128 vector_sqrt(__m128 a) { return _mm_sqrt_ps(a); }
inline __m128 vector_max(__m128 a, __m128 b) { return _mm_max_ps(a, b); }
inline __m128 vector_min(__m128 a, __m128 b) { return _mm_min_ps(a, b); }
#endif
#if defined(__AVX__)
inline __m256d vector_sqrt(__m256d a) { return _mm256_sqrt_pd(a); }
inline __m256d vector_max(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
inline __m256d vector_min(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
inline __m256 vector_sqrt(__m256 a) { return _mm256_sqrt_ps(a); }
inline __m256 vector_max(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
inline __m256 vector_min(__m256 a, __m256 b) { return _mm256_min_ps(a, b); }
#endif
#if defined(__AVX512F__)
// with a mask of ones: the plain intrinsics of g++ 12 warn of their own uninitialised variable (GCC bug 105593)
inline __m512d vector_sqrt(__m512d a) { return _mm512_maskz_sqrt_pd(0xff, a); }
inline __m512d vector_max(__m512d a, __m512d b) { return _mm512_maskz_max_pd(0xff, a, b); }
inline __m512d vector_min(__m512d a, __m512d b) { return _mm512_maskz_min_pd(0xff, a, b); }
inline __m512 vector_sqrt(__m512 a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
inline __m512 vector_max(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
inline __m512 vector_min(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }
#endif
#if defined(__FMA__)
inline __m128d vector_fused_add(__m128d a, __m128d b, __m128d c) { return _mm_fmadd_pd(a, b, c); }
inline __m128 vector_fused_add(__m128 a, __m128 b, __m128 c) { return _mm_fmadd_ps(a, b, c); }
inline __m256d vector_fused_add(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
inline __m256 vector_fused_add(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
inline __m128d vector_fused_subtract(__m128d a, __m128d b, __m128d c) { return _mm_fmsub_pd(a, b, c); }
inline __m128 vector_fused_subtract(__m128 a, __m128 b, __m128 c) { return _mm_fmsub_ps(a, b, c); }
inline __m256d vector_fused_subtract(__m256d a, __m256d b, __m256d c) { return _mm256_fmsub_pd(a, b, c); }
inline __m256 vector_fused_subtract(__m256 a, __m256 b, __m256 c) { return _mm256_fmsub_ps(a, b, c); }
#endif
#if defined(__AVX512F__)
inline __m512d vector_fused_add(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
inline __m512 vector_fused_add(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
inline __m512d vector_fused_subtract(__m512d a, __m512d b, __m512d c) { return _mm512_fmsub_pd(a, b, c); }
inline __m512 vector_fused_subtract(__m512 a, __m512 b, __m512 c) { return _mm512_fmsub_ps(a, b, c); }
#endif
}  // namespace detail

}  // namespace brouwer
