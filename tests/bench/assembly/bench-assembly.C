/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    bench-assembly

Description
    Speed of the flow's assembly, gather and scatter included, for every
    element family, against what the machine can do: a measured dgemm and a
    stream triad. Prints a table in Markdown:

        R         residual alone
        K         residual and the derivatives after velocity and pressure
        K+S       also those after the mesh's position
        scatter   share of K that adding to the matrix takes, done alone

    GFLOP/s are of the operations in the source, counted (countedFlops.H).
    Times are the best of several, as other programs may run; the gain of two
    threads wants an idle machine.

Usage
    bench-assembly [seconds per measurement, default 1 [words]]

    With words only the pairs of elements that have one of them in their names
\*---------------------------------------------------------------------------*/

#include "flowMesh.H"
#include "countedFlops.H"
#include "flowConstants.H"
#include "../shortestTime.H"
#include "fileOperation.H"
#include <cstdio>
#include <cstdlib>
#include <omp.h>
#include <string>
#include <vector>

extern "C" void dgemm_
(
    const char*, const char*, const int*, const int*, const int*, const double*,
    const double*, const int*, const double*, const int*, const double*, double*, const int*
);

using namespace Foam;

namespace
{

double seconds = 1;
std::vector<std::string> words;

bool wanted(const std::string& name)
{
    for (const std::string& word : words) if (name.find(word) != std::string::npos) return true;
    return words.empty();
}

template<class F>
double best(const F& f) { return shortestTime(seconds, f); }


//- One core, as OpenBLAS is told by its environment
void machine()
{
    const int n = 768;
    std::vector<double> A(n*n, 1.0), B(n*n, 2.0), C(n*n, 0.0);
    const double one = 1, nil = 0;
    const double t = best([&]()
    {
        dgemm_("N", "N", &n, &n, &n, &one, A.data(), &n, B.data(), &n, &nil, C.data(), &n);
    });
    std::printf("dgemm: %.1f GFLOP/s on one core. Stream triad:", 2.0*n*n*n/t*1e-9);

    const long m = 8000000;
    std::vector<double> a(m, 0.0), b(m, 1.0), c(m, 2.0);
    for (int threads = 1; threads <= 2; ++threads)
    {
        omp_set_num_threads(threads);
        const double s = best([&]()
        {
            #pragma omp parallel for schedule(static)
            for (long i = 0; i < m; ++i) a[i] = b[i] + 3.0*c[i];
        });
        std::printf(" %.1f GB/s (%d)", 24.0*m/s*1e-9, threads);
    }
    std::printf(".\n\n");
}


//- Adding matrices of all batches, without computing them
double scatterTime(flowMesh& m, feMatrix& K)
{
    const elementBlock& block = m.fe.blocks()[0];
    const label n = m.fe.dim()*block.nNodes;
    const std::vector<pack> values(n*n, pack(1e-3));
    return best([&]()
    {
        #pragma omp parallel
        block.forBatches([&](const label batch)
        {
            const pack* k = values.data();
            for (const label row : {0, 1}) for (const label col : {0, 1})
            {
                K.add(m.scatter[0], block, batch, k, row, col, 1);
            }
        });
    });
}


template<class V, class P, bool stabilised, bool general = false>
void bench(const word& cell, const FixedList<label, 3>& n, const double target)
{
    const std::string name =
        std::string(V::name) + '/' + P::name + (general ? " LES" : stabilised ? "" : " none");
    if (!wanted(name)) return;
    const bool plane = V::dim == 2;
    flowMesh m(cell, n, V::order, plane);
    m.k.stabilised = stabilised;
    if (general)
    {
        m.k.eddy = eddyModel::SMAGORINSKY;
        m.k.eddyConstant = 0.1;
    }
    m.randomise(0);
    feMatrix K(m.rows, m.rows, nullptr, m.scatter), S(m.rows, m.columns, nullptr, m.shapeScatter);
    flowMatrices toK;
    toK.K = &K;
    toK.scatter = &m.scatter;
    flowMatrices toBoth(toK);
    toBoth.S = &S;
    toBoth.shapeScatter = &m.shapeScatter;

    const kernelFlops flops = kernelFlops::of<V, P, stabilised, general>();
    const double work[] =
        {flops.residual, flops.residual + flops.tangent, flops.residual + flops.tangent + flops.shape};
    flowMatrices* const to[] = {nullptr, &toK, &toBoth};
    const label nElements = m.fe.nElements();

    double rate[2][3], scatter = 0;
    for (int threads = 1; threads <= 2; ++threads)
    {
        omp_set_num_threads(threads);
        for (int i = 0; i < 3; ++i) rate[threads - 1][i] = nElements/best([&]() { m.assemble(to[i]); });
        if (threads == 1) scatter = scatterTime(m, K)*rate[0][1]/nElements;
    }
    std::printf("| %s | %d |", name.c_str(), nElements);
    for (int i = 0; i < 3; ++i)
    {
        std::printf(" %.0f | %.1f |", 1e-3*rate[0][i], rate[0][i]*work[i]*1e-9);
    }
    std::printf(" %.0f %% | %.2f | %.2f |", 100*scatter, rate[1][0]/rate[0][0], rate[1][1]/rate[0][1]);
    if (target > 0) std::printf(" %.0f%s |\n", 1e-3*target, rate[0][1] >= target ? "" : " missed");
    else std::printf(" |\n");
    std::fflush(stdout);
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    if (argc > 1) seconds = std::atof(argv[1]);
    for (int i = 2; i < argc; ++i) words.push_back(argv[i]);
    fileHandler();   // says its line before the table
    double load = 0;
    getloadavg(&load, 1);
    std::printf("Packs of %d elements. Load average at the start: %.1f.\n", packSize, load);
    machine();
    std::printf
    (
        "Thousands of elements per second, one thread; x2: gain of two threads\n\n"
        "| element | number | R | GFLOP/s | K | GFLOP/s | K+S | GFLOP/s | scatter | R x2 | K x2 | target K |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n"
    );
    bench<Tri1, Tri1, true>("prism", {100, 100, 1}, 0);
    bench<Quad1, Quad1, true>("hex", {141, 141, 1}, 0);
    bench<Tri2, Tri1, false>("prism", {100, 100, 1}, 0);
    bench<Quad2, Quad1, false>("hex", {141, 141, 1}, 5e4);
    bench<Quad2, Quad1, true>("hex", {141, 141, 1}, 0);
    bench<Tet1, Tet1, true>("tet", {12, 12, 12}, 6e5);
    bench<Hex1, Hex1, true>("hex", {22, 22, 22}, 1e5);
    bench<Quad1, Quad1, true, true>("hex", {141, 141, 1}, 0);
    bench<Tet1, Tet1, true, true>("tet", {12, 12, 12}, 0);
    bench<Hex1, Hex1, true, true>("hex", {22, 22, 22}, 0);
    bench<Tet2, Tet1, false>("tet", {12, 12, 12}, 0);
    bench<Hex2, Hex1, false>("hex", {22, 22, 22}, 0);
    return 0;
}


// ************************************************************************* //
