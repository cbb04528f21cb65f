/* atan2 and acos with the same bits everywhere.
 *
 * Both functions are expanded about c, the nearest of 17 equidistant points to the argument c + h:
 *     f(c + h) = f(c) + f'(c) h + h^2 Q_c(h).
 * The first two terms are summed with their rounding errors: f' and h are split into 26 bits and a
 * rest, so the leading product is exact. The third term is below 2^-9 of the result and is
 * evaluated in plain double.
 * atan2 expands atan of q = b/a <= 1 and corrects for the quotient's remainder. acos expands asin
 * of |x| up to 1/2, and above that asin of sqrt((1 - |x|)/2), corrected for the error of the root.
 * Documented maximal errors: atan2 0.52 ulp, acos 0.51 ulp. Derivation:
 * docs/explanation/elementary-functions.md. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "base/double_double.h"
#include "base/elementary.h"

#define PI_HEAD 0x1.921fb54442d18p1
#define PI_TAIL 0x1.1a62633145c07p-53
#define HALF_PI_HEAD 0x1.921fb54442d18p0
#define HALF_PI_TAIL 0x1.1a62633145c07p-54

/* f(c) with its rest, f'(c) as 26 bits and the rest, and the coefficients of Q_c. */
typedef struct expansion {
    double value, value_tail, slope, slope_tail, q[9];
} expansion;

/* atan about i/16 */
/* clang-format off */
static const expansion arc_tangent[17] = {
    {0.0, 0.0, 0x1p0, 0.0,
     {0.0, -0x1.555555555554ap-2, 0.0, 0x1.99999998dfafdp-3, 0.0, -0x1.24923a9e038b3p-3, 0.0,
      0x1.c662766df4fbbp-4, 0.0}},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60, 0x1.fe01fep-1, 0x1.fe01fe01fe02p-33,
     {-0x1.fc05f809f40dfp-5, -0x1.4d69303ba8764p-2, 0x1.f61bc46d4b06ep-5, 0x1.82084caa5b702p-3,
      -0x1.eda84fe7bd3e5p-5, -0x1.057e2791118f9p-3, 0x1.e2c28183bcddbp-5, 0x1.79d98c5eb6ccep-4,
      -0x1.d48926084ba74p-5}},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59, 0x1.f81f82p-1, -0x1.f81f81f81f82p-31,
     {-0x1.f05e09d0dc11bp-4, -0x1.368c3aa76e1cdp-2, 0x1.d9b16b391c236p-4, 0x1.404899444828bp-3,
      -0x1.ba55da95fcdf2p-4, -0x1.652e470c1be66p-4, 0x1.939413a4d750dp-4, 0x1.7227af74817a8p-5,
      -0x1.66404d955149ap-4}},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58, 0x1.ee9c7f8p-1, 0x1.163807ba71fe1p-31,
     {-0x1.665c226d69eebp-3, -0x1.1344bb737e907p-2, 0x1.42aca8b929accp-3, 0x1.c32d8f693d3edp-4,
      -0x1.13e9ad22067cap-3, -0x1.17f40a70030b1p-5, 0x1.bc2ecb6059991p-4, -0x1.2c705fb992021p-7,
      -0x1.4a734500973a5p-4}},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57, 0x1.e1e1e2p-1, -0x1.e1e1e1e1e1e1ep-29,
     {-0x1.c5894d10d4986p-3, -0x1.ce6de0253d2c2p-3, 0x1.78a3a08d88af3p-3, 0x1.dd5f26a9a7506p-5,
      -0x1.1b1faecd4d9f9p-3, 0x1.0fc37ca73ed4ep-6, 0x1.73ba6d327f2dp-4, -0x1.9966ec1728cabp-5,
      -0x1.81ba046049b4ap-5}},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57, 0x1.d272cap-1, 0x1.fe2d8d35c03a5p-28,
     {-0x1.0997e8aec9d8ep-2, -0x1.6cf6666d5c13cp-3, 0x1.8dd1e8f2617cdp-3, 0x1.2483b3463872fp-7,
      -0x1.f495d2b104255p-4, 0x1.b909324d29228p-5, 0x1.d0572cfc8183dp-5, -0x1.1148369487bdfp-4,
      -0x1.d1f2c17b36d23p-8}},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56, 0x1.c0e07p-1, 0x1.c0e070381c0ep-28,
     {-0x1.2726dd135c174p-2, -0x1.09f37b38cc8f3p-3, 0x1.85eacd7da4163p-3, -0x1.04d6980df716fp-5,
      -0x1.8054c1e03ad17p-4, 0x1.2a47d34f0311fp-4, 0x1.4463d2c0a4229p-6, -0x1.f5094bc5d9938p-5,
      0x1.6ce4f48451f6p-6}},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56, 0x1.adbe88p-1, -0x1.adbe87f94905ep-31,
     {-0x1.3b9d8eab54af9p-2, -0x1.57c09645a7fadp-4, 0x1.6795318093913p-3, -0x1.f2d8bff08c442p-5,
      -0x1.f388166e244b5p-5, 0x1.32c449f36cc15p-4, -0x1.3f3ea0a06dff3p-7, -0x1.5c51085881f43p-5,
      0x1.1b62d5fe7c7dfp-5}},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56, 0x1.9999998p-1, 0x1.999999999999ap-29,
     {-0x1.47ae147ae147bp-2, -0x1.5d867c3ece277p-5, 0x1.3a92a30553272p-3, -0x1.3ec460edcdb8cp-4,
      -0x1.ec21b51695b65p-6, 0x1.0a84a3e90f2ecp-4, -0x1.c2f89f96ee5e1p-6, -0x1.57013413763d4p-6,
      0x1.0b671ebf724bdp-5}},
    {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56, 0x1.84f00cp-1, 0x1.3c0309e0184fp-28,
     {-0x1.4c62cb562c625p-2, -0x1.e6495b3a4ba6ap-8, 0x1.063c2f78c0dc6p-3, -0x1.58b7845a65e97p-4,
      -0x1.41c8313989aep-8, 0x1.938d77119a06fp-5, -0x1.16d9947c45a0ep-5, -0x1.ae4b87f500e4cp-9,
      0x1.7bc563b3eb2f7p-6}},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58, 0x1.702e06p-1, -0x1.fa3f47e8fd1fap-28,
     {-0x1.4af2b78215a76p-2, 0x1.5d0b7e9e4aa57p-6, 0x1.a1247ca629938p-4, -0x1.519e1100a909ap-4,
      0x1.a75923272eca2p-7, 0x1.0949598769d35p-5, -0x1.09bb9e57df847p-5, 0x1.fd746995c0d72p-8,
      0x1.94e4abbcdd4eap-7}},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55, 0x1.5babcc8p-1, -0x1.b8056eaf3192p-29,
     {-0x1.449db094286dp-2, 0x1.655caac4cf131p-5, 0x1.3bbbd2933dd8dp-4, -0x1.34a2f963b93ebp-4,
      0x1.84d71a24c9475p-6, 0x1.1f9ae167e16d9p-6, -0x1.b0ff15440da5fp-6, 0x1.9e326b9d44792p-7,
      0x1.e8f4ff0088494p-9}},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56, 0x1.47ae148p-1, -0x1.47ae147ae147bp-31,
     {-0x1.3a92a30553261p-2, 0x1.ec21b514d88f1p-5, 0x1.c2f8b88dfb7f2p-5, -0x1.0ba9908c9b99ep-4,
      0x1.d7b0c3d84becfp-6, 0x1.95395928b42ep-8, -0x1.37822d6de0b77p-6, 0x1.ae643841e0382p-7,
      -0x1.a672ed014514bp-10}},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57, 0x1.34679bp-1, -0x1.8ff65cc3298ffp-28,
     {-0x1.2ddfb03913da2p-2, 0x1.2491307b46909p-4, 0x1.29c7e4b96b762p-5, -0x1.bca781f08f61dp-5,
      0x1.e63cec4bee85ep-6, -0x1.95296c31558e2p-10, -0x1.8bf44bcb85b99p-7, 0x1.70186460394c8p-7,
      -0x1.0aa2c19362522p-8}},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56, 0x1.21fb78p-1, 0x1.21fb78121fb78p-29,
     {-0x1.1f6a8499e4889p-2, 0x1.41b15e5decb17p-4, 0x1.59bc940a374a2p-6, -0x1.63b54400d0989p-5,
      0x1.c90e857753cbep-6, -0x1.91f7882ffcaabp-8, -0x1.abfbd3e7e3a24p-8, 0x1.1515049639fe3p-7,
      -0x1.2c1ae1ab9dce9p-8}},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56, 0x1.107fbcp-1, -0x1.feef80441fefp-29,
     {-0x1.0feeb40894fcdp-2, 0x1.50e5afb9125f4p-4, 0x1.2a7c2843ba54dp-7, -0x1.12bd24b49c675p-5,
      0x1.93fe0f3b31731p-6, -0x1.1156e1604d816p-7, -0x1.4f63babd58131p-9, 0x1.7738951381f09p-8,
      -0x1.0956f853d084ep-8}},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55, 0x1p-1, 0.0,
     {-0x1p-2, 0x1.5555555555552p-4, -0x1.11266d69d5e37p-60, -0x1.999999996dffbp-6,
      0x1.5555555555c0cp-6, -0x1.24924e0c59c4fp-7, -0x1.ab036befe11d4p-37, 0x1.c7851c2705c5p-9,
      -0x1.999955ddcc23p-9}},
};
/* clang-format on */

/* asin about i/32 */
/* clang-format off */
static const expansion arc_sine[17] = {
    {0.0, 0.0, 0x1p0, 0.0,
     {0.0, 0x1.5555555555555p-3, 0.0, 0x1.3333333334a2p-4, 0.0, 0x1.6db6da887d431p-5, 0.0,
      0x1.f1f4f262eab08p-6, 0.0}},
    {0x1.000aabde0b9c8p-5, 0x1.d6d94551be3e9p-61, 0x1.002006p0, 0x1.40460fc39cd6bp-32,
     {0x1.00601e08c276bp-6, 0x1.56d61da71d91fp-3, 0x1.8190f57651b41p-7, 0x1.36f709ca1c082p-4,
      0x1.428fecb2e53afp-7, 0x1.7685ad1482cc1p-5, 0x1.1bb699496b9e8p-7, 0x1.02efd54c9ce5ap-5,
      0x1.01234b68108d3p-7}},
    {0x1.002abde953619p-4, 0x1.182e2dc6ddeedp-58, 0x1.0080608p0, -0x1.7dce0630516c5p-27,
     {0x1.0181e23278b7fp-5, 0x1.5b61e9ddafe71p-3, 0x1.864f6db9edaep-6, 0x1.427119fb2e092p-4,
      0x1.4a5f258b30e21p-6, 0x1.91a6de22f8b52p-5, 0x1.271ebf226ffddp-6, 0x1.21f9aed6fb6dp-5,
      0x1.10aa0cd6d6ffep-6}},
    {0x1.809092913e52ep-4, 0x1.cf6b1f9befb16p-60, 0x1.0121e98p0, 0x1.650546842a2f2p-28,
     {0x1.851e62bfa7b8p-5, 0x1.631588e23b648p-3, 0x1.2ac723cfd763bp-5, 0x1.5630c74c15716p-4,
      0x1.01db090c5c5a1p-5, 0x1.c14e69ac0ff8p-5, 0x1.d89484c66e181p-6, 0x1.59e5f74b9b427p-5,
      0x1.c2767428c5ad3p-6}},
    {0x1.00abe0c129e1ep-3, 0x1.7ceb0ee49d42ap-60, 0x1.0206148p0, -0x1.c802b327c9bafp-27,
     {0x1.061e8e8103b88p-4, 0x1.6e228e2a0d52fp-3, 0x1.99fc94d90434fp-5, 0x1.7331fb4c73efap-4,
      0x1.6b89bd1c5ab93p-5, 0x1.04ba605d57f27p-4, 0x1.5903bde276068p-5, 0x1.b1c05a883ae0cp-5,
      0x1.57057c07eb5fp-5}},
    {0x1.41510cb011423p-3, -0x1.15d675180eda8p-58, 0x1.032ef4p0, -0x1.4479a7e460cecp-29,
     {0x1.4c163be9c863ep-4, 0x1.7cd1cbdad651ap-3, 0x1.09f2314e3cd56p-4, 0x1.9af235aa4eb7bp-4,
      0x1.e839f4c63d87dp-5, 0x1.382bae1ff21d3p-4, 0x1.e43491a9842cbp-5, 0x1.1a8c0a154f5dfp-4,
      0x1.fb056bb33e436p-5}},
    {0x1.82494ed0e78fcp-3, -0x1.443c2697a7d2fp-57, 0x1.049f4bp0, 0x1.95b676ddc4833p-29,
     {0x1.952d8a70fd76cp-4, 0x1.8f871364b45f7p-3, 0x1.4e153e6ec33c1p-4, 0x1.cf91aa6f444bp-4,
      0x1.3fcca03294dd8p-4, 0x1.7fa5ea4d0e771p-4, 0x1.4e3a6dfc2e19p-4, 0x1.7b16418a8020ap-4,
      0x1.73bc17547148dp-4}},
    {0x1.c3a6f13aae84bp-3, -0x1.7739d10fe8bc1p-57, 0x1.065a9d8p0, 0x1.8132e5aada23ap-28,
     {0x1.e231717821274p-4, 0x1.a6c69045eb07ep-3, 0x1.9ba2404c9cc03p-4, 0x1.0a0269f02bb3fp-3,
      0x1.9de9c0e53a53ap-4, 0x1.e206b2c7a443cp-4, 0x1.cb6a7c3a94ffdp-4, 0x1.04648cdabfc2p-3,
      0x1.11614931309f6p-3}},
    {0x1.02be9ce0b87cdp-2, 0x1.e5d09da2e0f04p-58, 0x1.08654ap0, 0x1.6a7b6d40650abp-27,
     {0x1.1a05a47498fd8p-3, 0x1.c33c3a5427fbfp-3, 0x1.f55f5d410ffb6p-4, 0x1.362eb5f053d7dp-3,
      0x1.0aaf844bff0b8p-3, 0x1.34b1f6aa081e2p-3, 0x1.3ca354595d6f4p-3, 0x1.6d13fb7930d9cp-3,
      0x1.95dd0f8334b19p-3}},
    {0x1.23f0523c5dc2bp-2, 0x1.4fc2674a3d6b2p-59, 0x1.0ac4aa8p0, -0x1.735206a271885p-27,
     {0x1.45e49457b8d6p-3, 0x1.e5c6183ac4585p-3, 0x1.2f693e7e098ffp-3, 0x1.6f1adb5ca0917p-3,
      0x1.57e4eb1121606p-3, 0x1.92541acfa3e5bp-3, 0x1.b7bc39eeee181p-3, 0x1.04c81823b194ep-2,
      0x1.3151b26d899b6p-2}},
    {0x1.457393b90e2aap-2, 0x1.b1f64d329fe98p-56, 0x1.0d7f3c8p0, -0x1.63d71e8195634p-27,
     {0x1.755446452737bp-3, 0x1.07c130faff1d4p-2, 0x1.6e451a9f5f5bfp-3, 0x1.b8a7ae22bc79dp-3,
      0x1.bd6593333f9b3p-3, 0x1.0a897f38fa99cp-2, 0x1.34a8031a8f274p-2, 0x1.7b8138960de7bp-2,
      0x1.d2e5e288f2da3p-2}},
    {0x1.675441329986ep-2, 0x1.d027ed2bb2edap-56, 0x1.109cd98p0, -0x1.e3ccce304bc5dp-27,
     {0x1.a9120cbe5685ep-3, 0x1.20f18b0be2abep-2, 0x1.ba42a20e8ba2cp-3, 0x1.0c2059c637af3p-2,
      0x1.2284782c07b27p-2, 0x1.66f1d17d5c26ap-2, 0x1.b72877b2038a8p-2, 0x1.196db8b1881ap-1,
      0x1.6bbe8085a7968p-1}},
    {0x1.899f4edc962d3p-2, 0x1.3e919701b7c6dp-60, 0x1.1426fbp0, -0x1.fcd592a1299bap-27,
     {0x1.e202df90fb4b1p-3, 0x1.3f64af08aaa66p-2, 0x1.0bb20b9b6a21cp-2, 0x1.4ac896e06856p-2,
      0x1.7ea574d1f77b8p-2, 0x1.eb80020c414d3p-2, 0x1.3d60f2cfc3d27p-1, 0x1.a9e00b339ce25p-1,
      0x1.216b493751d6cp0}},
    {0x1.ac62fec0b2a92p-2, 0x1.cb9f9a052f11fp-56, 0x1.182916p0, -0x1.b687cd0cb0208p-27,
     {0x1.109fbef7deb6ep-2, 0x1.64562d09aa28cp-2, 0x1.458e6f03ee02ap-2, 0x1.9dce4877d26cbp-2,
      0x1.fdf49fcf98556p-2, 0x1.567332985cb99p-1, 0x1.d311c4954aa22p-1, 0x1.4950c334ae19fp0,
      0x1.d787a30a00569p0}},
    {0x1.cfaf27460fe9fp-2, -0x1.8bf75f355f723p-57, 0x1.1cb112p0, -0x1.eb90886198d3ep-29,
     {0x1.341278d2eebedp-2, 0x1.91687471015dbp-2, 0x1.8e7b9b5b3dd3ep-2, 0x1.069e7e5d7cc26p-1,
      0x1.588e5aa366468p-1, 0x1.e647b0e57881ep-1, 0x1.5ebdd8b757e77p0, 0x1.04cc0cdf2dab4p1,
      0x1.8a536cad52c61p1}},
    {0x1.f3958aecddef4p-2, -0x1.fc135930a7786p-58, 0x1.21cfe78p0, 0x1.53cc546f9b7afp-29,
     {0x1.5c35b665d4687p-2, 0x1.c8cda1320fc9ep-2, 0x1.ebc9642da325ep-2, 0x1.52886c9adc3d3p-1,
      0x1.d9225c6b18cd9p-1, 0x1.607449f4fb52bp0, 0x1.0d7d1b8ac9eecp1, 0x1.a82378af5cddbp1,
      0x1.53932697146cap2}},
    {0x1.0c152382d7366p-1, -0x1.ee6913347c2a6p-55, 0x1.279a748p0, -0x1.37e671d96f384p-27,
     {0x1.8a2345cc04426p-2, 0x1.06c22e8802d5cp-1, 0x1.328d364958a35p-1, 0x1.bbc51b63d1e43p-1,
      0x1.4ae18fee7f803p0, 0x1.055e38e4739fep1, 0x1.a8f46bc6026efp1, 0x1.633e5ca70fab2p2,
      0x1.2e36d85524e24p3}},
};
/* clang-format on */

/* An angle is head + tail + sign f, where f is in the first octant. */
typedef struct octant {
    double head, tail, sign;
} octant;

/* Index: 1 if f counts from pi/2, plus 2 if the angle is beyond pi/2. */
static const octant octants[4] = {
    {0.0, 0.0, 1.0},
    {HALF_PI_HEAD, HALF_PI_TAIL, -1.0},
    {PI_HEAD, PI_TAIL, -1.0},
    {HALF_PI_HEAD, HALF_PI_TAIL, 1.0},
};

/* f(c + h) = result + *rest */
static inline double expand(const expansion *f, double h, double *rest)
{
    const double *q = f->q;
    double h_head = head_of(h), h2 = h * h, h4 = h2 * h2;
    double low = (q[0] + h * q[1]) + h2 * (q[2] + h * q[3]);
    double high = (q[4] + h * q[5]) + h2 * (q[6] + h * q[7]) + h4 * q[8];
    double error, sum = two_sum_ordered(f->value, f->slope * h_head, &error);
    double linear = f->value_tail + (f->slope * (h - h_head) + f->slope_tail * h);
    *rest = (error + linear) + h2 * (low + h4 * high);
    return sum;
}

/* f(c + h + tail) - f(c + h) for a tail below 2 ulp of c + h. */
static inline double tail_of(const expansion *f, double h, double tail)
{
    return (f->slope + (h + h) * f->q[0]) * tail;
}

/* base + sign (sum + rest) */
static inline double apply_octant(const octant *base, double sum, double rest)
{
    double error, total = two_sum_ordered(base->head, base->sign * sum, &error);
    return total + (error + (base->tail + base->sign * rest));
}

/* Angle for 0 < b <= a of moderate exponents, so that no product here leaves the normal range. */
static inline double angle_of(double b, double a, unsigned octant_index)
{
    double inverse = 1.0 / a, q = b * inverse;
    /* The remainder b - q a: q is within 2 ulp of b/a, and the roundings here are below 2^-76 b. */
    double q_head = head_of(q), q_rest = q - q_head, a_head = head_of(a), a_rest = a - a_head;
    double left = ((b - q_head * a_head) - q_head * a_rest) - q_rest * a_head - q_rest * a_rest;
    double shifted = q + 0x1.8p48; /* rounds to 1/16 */
    double h = q - (shifted - 0x1.8p48), rest;
    const expansion *f = &arc_tangent[bits_of(shifted) & 31u];
    double sum = expand(f, h, &rest);
    return apply_octant(&octants[octant_index], sum, rest + tail_of(f, h, left * inverse));
}

/* Angle in the remaining cases: NaN, zeros, infinities, extreme exponents and ratios. Both
 * arguments are magnitudes. */
static double rare_angle(double y, double x, unsigned octant_index)
{
    double a = octant_index & 1u ? y : x, b = octant_index & 1u ? x : y;
    if (!(a <= DBL_MAX && b <= DBL_MAX)) {
        if (a != a || b != b) {
            return canonical_nan();
        }
        if (a == b) { /* both infinite: 3 pi/4 or pi/4 */
            return octant_index & 2u ? 0x1.2d97c7f3321d2p1 : 0x1.921fb54442d18p-1;
        }
        b = 0.0; /* any finite number is zero relative to an infinity */
    }
    if (b == 0.0) {
        return octants[octant_index].head;
    }
    if (b < a * 0x1p-60) {
        /* b/a is below the rounding error of pi/2 and pi; in the first octant it is its own arc
         * tangent. */
        return octant_index ? octants[octant_index].head : b / a;
    }
    double scale = a > 1.0 ? 0x1p-200 : 0x1p300;
    return angle_of(b * scale, a * scale, octant_index);
}

double vbss_arc_tangent(double y, double x)
{
    double x_size = fabs(x), y_size = fabs(y);
    bool steep = y_size > x_size;
    double a = steep ? y_size : x_size, b = steep ? x_size : y_size;
    uint64_t a_exponent = bits_of(a) >> 52, b_exponent = bits_of(b) >> 52;
    unsigned octant_index = (steep ? 1u : 0u) + (bits_of(x) >> 63 != 0 ? 2u : 0u);
    double angle;
    /* 2^-900 <= a < 2^900 and b/a > 2^-61, which excludes zeros, infinities and NaN. */
    if (a_exponent - 123u < 1800u && a_exponent - b_exponent <= 60u) {
        angle = angle_of(b, a, octant_index);
    } else {
        angle = rare_angle(y_size, x_size, octant_index);
        if (angle != angle) {
            return angle;
        }
    }
    return double_of(bits_of(angle) | (bits_of(y) & UINT64_C(1) << 63));
}

double vbss_arc_cosine(double x)
{
    double size = fabs(x), rest, sum;
    if (size <= 0.5) {
        double shifted = size + 0x1.8p47; /* rounds to 1/32 */
        sum = expand(&arc_sine[bits_of(shifted) & 31u], size - (shifted - 0x1.8p47), &rest);
        return apply_octant(&octants[x < 0.0 ? 3 : 1], sum, rest);
    }
    if (!(size < 1.0)) {
        return x == 1.0 ? 0.0 : x == -1.0 ? PI_HEAD : canonical_nan();
    }
    /* acos |x| = 2 asin sqrt z, and z is exact. The error of the root s is (z - s^2)/(2 s),
     * computed as (z - s^2) s/(2 z) so that the division and the root can run at the same time. */
    double z = 0.5 * (1.0 - size), half_inverse = 0.5 / z, s = sqrt(z);
    double s_head = head_of(s), s_rest = s - s_head;
    double left = ((z - s_head * s_head) - 2.0 * s_head * s_rest) - s_rest * s_rest;
    double shifted = s + 0x1.8p47, h = s - (shifted - 0x1.8p47);
    const expansion *f = &arc_sine[bits_of(shifted) & 31u];
    sum = expand(f, h, &rest);
    rest += tail_of(f, h, left * (s * half_inverse));
    if (x > 0.0) {
        return 2.0 * (sum + rest);
    }
    return apply_octant(&octants[2], 2.0 * sum, 2.0 * rest);
}
