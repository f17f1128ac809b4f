/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    bench-solid

Description
    Speed of the solid's assembly, gather and scatter included, for kinds of
    elements and two laws. Prints a table in Markdown of thousands of elements a
    second:

        R         forces and, of mixed elements, residuals of the volume
        K         these and the tangent
        x2        gain of two threads, which wants an idle machine

Usage
    bench-solid [seconds per measurement, default 1]
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "solidAssembly.H"
#include "fieldUnknowns.H"
#include "IStringStream.H"
#include "Random.H"
#include "fileOperation.H"
#include "../shortestTime.H"
#include <cstdio>
#include <cstdlib>
#include <omp.h>
#include <string>

using namespace Foam;

namespace
{

struct solidMesh
{
    const solidElements& elements;
    shapeMesh box;
    feMesh fe;
    solidAssembly assembly;
    fieldLayout layout;
    nodeMap map;
    fieldUnknowns unknowns;
    PtrList<elementScatter> scatter;
    feMatrix K;
    mixedStage stage;
    vectorField force;
    scalarField volume;

    static dictionary dict(const std::string& entries)
    {
        IStringStream is(entries);
        return dictionary(is);
    }

    static List<fieldLayout::field> fields(const solidElements& e)
    {
        List<fieldLayout::field> all(e.mixed ? 2 : 1);
        all[0] = {"pointD", fieldLayout::kind::VECTOR, fieldLayout::support::NODES, dimLength};
        if (e.mixed) all[1] = {"solidPressure", fieldLayout::kind::SCALAR, e.pressureOn, dimPressure};
        return all;
    }

    static PtrList<elementScatter> scatters(const List<elementBlock>& blocks, const fieldUnknowns& unknowns)
    {
        PtrList<elementScatter> list;
        for (const elementBlock& block : blocks) list.append(new elementScatter(block, unknowns));
        return list;
    }

    solidMesh
    (
        const std::string& kind, const std::string& law, const word& cell, const FixedList<label, 3>& n
    )
    :
        elements(solidElements::select(dict("elements " + kind + ";"))),
        box
        (
            cell, n, [](const point& p) { return point(p.x() + 0.1*p.y(), p.y() + 0.1*::sin(3*p.x()), p.z()); },
            n[2] == 1 ? shapeMesh::twoD() : HashTable<word>()
        ),
        fe(box.mesh(), elements.order, dictionary()),
        assembly(fe, elements, dict("materials ( body { rho 1; " + law + " } );")),
        layout(fe, fields(elements)),
        map(layout.keys(), fieldUnknowns::counts(layout)),
        unknowns(layout, map),
        scatter(scatters(assembly.blocks(), unknowns)),
        K(map, map, nullptr, scatter),
        stage(fe.points(), {fe.axis(0), fe.axis(1), fe.axis(2)}),
        force(fe.nNodes(), Zero),
        volume(elements.mixed ? layout.size(1) : 0, 0)
    {
        Random random(1);
        stage.enhanced = elements.enhanced;
        stage.pressureOn = elements.pressureOn;
        stage.p = volume;
        const scalar size = 0.02*fe.meanSize();
        for (vector& D : stage.D)
        {
            D = size*random.GaussNormal<vector>();
            if (fe.dim() == 2) D[fe.axis(2)] = 0;
        }
    }

    void assemble(feMatrix* to) { assembly.assemble(stage, force, volume, to, scatter); }
};


const char* const neoHookean = "type neoHookean; E 100; nu 0.3;";
const char* const MooneyRivlin = "type MooneyRivlin; c1 10; c2 3; bulkModulus 1e3;";

void bench
(
    const double seconds,
    const std::string& kind,
    const char* law,
    const word& cell,
    const FixedList<label, 3>& n
)
{
    solidMesh m(kind, law, cell, n);
    double rate[2][2];
    for (int threads = 1; threads <= 2; ++threads)
    {
        omp_set_num_threads(threads);
        for (int tangent = 0; tangent < 2; ++tangent)
        {
            rate[threads - 1][tangent] =
                1e-3*m.fe.nElements()/shortestTime(seconds, [&]() { m.assemble(tangent ? &m.K : nullptr); });
        }
    }
    std::printf
    (
        "| %s | %s | %s | %d | %.0f | %.0f | %.2f | %.2f |\n", kind.c_str(),
        n[2] > 1 ? cell.c_str() : cell == "hex" ? "quad" : "tri", law == neoHookean ? "neoHookean" : "MooneyRivlin",
        m.fe.nElements(), rate[0][0], rate[0][1], rate[1][0]/rate[0][0], rate[1][1]/rate[0][1]
    );
    std::fflush(stdout);
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    const double seconds = argc > 1 ? std::atof(argv[1]) : 1;
    fileHandler();   // says its line before the table
    double load = 0;
    getloadavg(&load, 1);
    std::printf
    (
        "Packs of %d elements. Load average at the start: %.1f. Thousands of elements per second, one thread\n\n"
        "| elements | shape | law | number | R | K | R x2 | K x2 |\n|---|---|---|---|---|---|---|---|\n",
        packSize, load
    );
    const FixedList<label, 3> plane({141, 141, 1}), solid({22, 22, 22}), tets({12, 12, 12});
    for (const char* law : {neoHookean, MooneyRivlin})
    {
        for (const char* kind : {"linear", "enhancedStrain", "quadratic"}) bench(seconds, kind, law, "hex", plane);
        for (const char* kind : {"linear", "enhancedStrain", "quadratic"}) bench(seconds, kind, law, "hex", solid);
        for (const char* kind : {"linear", "quadratic"}) bench(seconds, kind, law, "tet", tets);
    }
    for (const char* kind : {"Q1Q0", "equalOrder", "taylorHood"}) bench(seconds, kind, MooneyRivlin, "hex", solid);
    for (const char* kind : {"equalOrder", "taylorHood"}) bench(seconds, kind, MooneyRivlin, "tet", tets);
    return 0;
}


// ************************************************************************* //
