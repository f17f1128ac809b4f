/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-remeshing

Description
    Tests of the exchange of a mesh: what stays, how good it becomes, and how
    accurate the mapping of the state is.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "runOnRanks.H"
#include "complaint.H"
#include "remesher.H"
#include "remeshSelection.H"
#include "remeshCriteria.H"
#include "simplexExchange.H"
#include "meshMapping.H"
#include "emptyPolyPatch.H"
#include "IStringStream.H"

using namespace Foam;

namespace
{

//- Of triangles or tetrahedra, n to a side, turned by an angle in the middle
struct turnedMesh
{
    shapeMesh box;
    feMesh fe;

    turnedMesh(const label dim, const label n, const label order, const scalar angle = 1)
    :
        box
        (
            dim == 2 ? "prism" : "tet", {n, n, dim == 2 ? 1 : n},
            [=](const point& p)
            {
                const vector r(p.x() - 0.5, p.y() - 0.5, 0);
                const scalar z = dim == 2 ? 0.5 : p.z(), a = angle*max(1 - 2*mag(r), 0.0)*4*z*(1 - z);
                return point
                (
                    0.5 + r.x()*::cos(a) - r.y()*::sin(a), 0.5 + r.x()*::sin(a) + r.y()*::cos(a), p.z()
                );
            },
            dim == 2 ? shapeMesh::twoD() : HashTable<word>()
        ),
        fe(box.mesh(), order, dictionary())
    {}

    labelList all() const { return identity(box.mesh->nCells()); }
};


//- The mesh after an exchange of some cells
struct exchangedMesh
{
    string failure;
    meshExchange exchange;
    autoPtr<polyMesh> mesh;
    autoPtr<feMesh> fe;
    boolList made;

    exchangedMesh(const turnedMesh& old, const labelList& cells, const remesher::sizeField& size)
    {
        const dictionary dict(IStringStream("remesher CGAL;")());
        labelList nodes;
        const simplexMesh s(simplicesOf(old.fe, old.fe.points(), cells, nodes));
        simplexMesh now;
        failure = remesher::New(dict, old.box.time())->remesh(s, size, now);
        if (failure.empty())
        {
            failure = simplexExchange(old.fe, old.box.mesh->points(), cells).make(now, nodes, exchange);
        }
        if (!failure.empty()) return;
        const polyMesh& from = old.box.mesh();
        mesh.reset
        (
            new polyMesh
            (
                IOobject("exchanged", from.time().constant(), from.time()),
                pointField(exchange.points), faceList(exchange.faces),
                labelList(exchange.owner), labelList(exchange.neighbour)
            )
        );
        List<polyPatch*> patches;
        for (const polyPatch& pp : from.boundaryMesh())
        {
            const label p = pp.index();
            patches.append(pp.clone(mesh->boundaryMesh(), p, exchange.patchSizes[p], exchange.patchStarts[p]).ptr());
        }
        mesh->addPatches(patches);
        fe.reset(new feMesh(mesh(), old.fe.order(), dictionary()));
        made = boolList(exchange.cellMap.size());
        const elementSearch search(old.fe, old.fe.points());
        forAll(made, c)
        {
            made[c] = exchange.cellMap[c] < 0;
            if (made[c]) exchange.cellMap[c] = search.cell(search.find(mesh->cellCentres()[c], 1e-6));
        }
    }
};


scalar worstAspectRatio(const feMesh& fe)
{
    scalar worst = 0;
    for (const auto& block : qualities(fe, fe.points())) for (const auto& q : block) worst = max(worst, q.aspectRatio);
    return worst;
}

scalar worstJacobian(const feMesh& fe)
{
    scalar worst = 1;
    for (const auto& block : qualities(fe, fe.points())) for (const auto& q : block) worst = min(worst, q.scaledJacobian);
    return worst;
}

scalar volume(const polyMesh& mesh) { return sum(mesh.cellVolumes()); }


struct errors
{
    scalar largest, rms;
};

//- Errors at the new nodes of a field that has been mapped to an exchanged mesh
template<class F>
errors mappingErrors(const label dim, const label n, const label order, const F& f)
{
    const turnedMesh old(dim, n, order, 0.6);
    const exchangedMesh now(old, old.all(), [=](const point&) { return 1.1/n; });
    EXPECT_EQ(now.failure, "");
    const elementSearch search(old.fe, old.fe.points());
    stateMap map;
    meshMapping::New(dictionary())->map
    (
        {old.fe, old.fe.points(), search, now.exchange.pointMap, now.exchange.cellMap, now.made}, now.fe(), map
    );
    scalarField values(old.fe.nNodes());
    forAll(values, i) values[i] = f(old.fe.points()[i]);
    const scalarField mapped(map.nodes(values));
    EXPECT_EQ(mapped.size(), now.fe->nNodes());
    errors e{0, 0};
    label nNew = 0;
    forAll(mapped, i)
    {
        if (map.nodes.from[i].size() == 1) continue;
        const scalar error = mapped[i] - f(now.fe->points()[i]);
        e.largest = max(e.largest, mag(error));
        e.rms += sqr(error);
        ++nNew;
    }
    EXPECT_GT(nNew, 10);
    e.rms = ::sqrt(e.rms/nNew);

    // Vertices have the linear part
    const scalarField vertices(map.vertices(scalarField(SubField<scalar>(old.fe.points().component(0)(), old.fe.nVertices()))));
    forAll(vertices, i) EXPECT_NEAR(vertices[i], now.fe->points()[i].x(), 1e-13);
    return e;
}


class dimensions : public ::testing::TestWithParam<label> {};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- All cells: the boundary's points and faces are the same, to the bit and in
//  the same order, the volume too, and the elements are better
TEST_P(dimensions, keepsTheBoundary)
{
    const turnedMesh old(GetParam(), 8, 1, 1.4);
    const exchangedMesh now(old, old.all(), [](const point&) { return 0.13; });
    ASSERT_EQ(now.failure, "");
    EXPECT_FALSE(now.mesh->checkMesh());
    EXPECT_NEAR(volume(now.mesh()), 1, 1e-13);
    EXPECT_GT(worstJacobian(now.fe()), 1.2*worstJacobian(old.fe));
    EXPECT_LT(worstAspectRatio(now.fe()), worstAspectRatio(old.fe));
    forAll(now.mesh->boundaryMesh(), patchi)
    {
        const polyPatch &a = old.box.mesh->boundaryMesh()[patchi], &b = now.mesh->boundaryMesh()[patchi];
        if (isA<emptyPolyPatch>(a)) continue;
        ASSERT_EQ(a.size(), b.size());
        forAll(a, i) EXPECT_EQ(a[i].points(old.box.mesh->points()), b[i].points(now.mesh->points()));
    }
}


//- Some cells: the others are the same, to the bit and in the same order
TEST_P(dimensions, keepsWhatIsNotSelected)
{
    const turnedMesh old(GetParam(), 8, 1, 1.2);
    DynamicList<label> cells, others;
    const pointField& centres = old.box.mesh->cellCentres();
    forAll(centres, c) (mag(centres[c].x() - 0.5) < 0.3 ? cells : others).append(c);
    const exchangedMesh now(old, cells, [](const point&) { return 0.13; });
    ASSERT_EQ(now.failure, "");
    EXPECT_FALSE(now.mesh->checkMesh());
    EXPECT_NEAR(volume(now.mesh()), 1, 1e-13);
    forAll(others, i)
    {
        EXPECT_FALSE(now.made[i]);
        EXPECT_EQ(now.exchange.cellMap[i], others[i]);
        const labelList a(old.box.mesh->cells()[others[i]].labels(old.box.mesh->faces()));
        labelList b(now.mesh->cells()[i].labels(now.mesh->faces()));
        for (label& p : b) p = now.exchange.pointMap[p];
        EXPECT_EQ(labelHashSet(a), labelHashSet(b));
    }
    forAll(now.exchange.pointMap, p)
    {
        const label from = now.exchange.pointMap[p];
        if (from < 0) continue;
        EXPECT_EQ(now.mesh->points()[p], old.box.mesh->points()[from]);
    }
}


//- Edges have the sizes that are asked for
TEST_P(dimensions, gradesTheSize)
{
    const turnedMesh old(GetParam(), GetParam() == 2 ? 20 : 10, 1, 0);
    const scalar h = GetParam() == 2 ? 0.02 : 0.06;
    const auto size = [=](const point& p) { return h*(1 + 4*mag(p - point(0.5, 0.5, p.z()))); };
    const exchangedMesh now(old, old.all(), size);
    ASSERT_EQ(now.failure, "");
    scalar sum = 0;
    label n = 0;
    for (const edge& e : now.mesh->edges())
    {
        const point c(e.centre(now.mesh->points()));
        const scalar l = e.mag(now.mesh->points());
        if (mag(c - point(0.5, 0.5, c.z())) > 0.35 || (GetParam() == 3 && mag(c.z() - 0.5) > 0.3)) continue;
        if (GetParam() == 2 && mag(e.vec(now.mesh->points()).z()) > 0.5) continue;
        sum += l/size(c);
        ++n;
    }
    EXPECT_NEAR(sum/n, 1, 0.1);
}


//- Ten motions: none fails, no element is inverted
TEST_P(dimensions, survivesMotions)
{
    for (label i = 0; i < 10; ++i)
    {
        const label n = GetParam() == 2 ? 10 + i : 4;
        const turnedMesh old(GetParam(), n, 1, 0.2*(i - 4.5));
        const exchangedMesh now(old, old.all(), [=](const point& p) { return (0.7 + 0.06*i)*(1 + p.x())/n; });
        ASSERT_EQ(now.failure, "") << i;
        EXPECT_NEAR(volume(now.mesh()), 1, 1e-13) << i;
        EXPECT_GT(worstJacobian(now.fe()), GetParam() == 2 ? 0.3 : 0.05) << i;
    }
}


TEST_P(dimensions, interpolatesLinearFieldsExactly)
{
    for (const label order : {1, 2})
    {
        const scalar error = mappingErrors
        (
            GetParam(), 6, order, [](const point& x) { return 1 + 2*x.x() - 3*x.y(); }
        ).largest;
        EXPECT_LT(error, 1e-12) << "order " << order;
    }
}


TEST_P(dimensions, interpolatesQuadraticFieldsExactlyAtOrder2)
{
    const scalar error = mappingErrors
    (
        GetParam(), 6, 2, [](const point& x) { return sqr(x.x()) - 2*x.x()*x.y() + 0.5*sqr(x.y()); }
    ).largest;
    EXPECT_LT(error, 1e-12);
}


//- Second and third order
TEST_P(dimensions, hasTheOrderOfItsElements)
{
    const label n = GetParam() == 2 ? 12 : 4;
    for (const label order : {1, 2})
    {
        const auto f = [](const point& x) { return ::sin(3*x.x() + 0.4)*::cos(2*x.y()); };
        const scalar coarse = mappingErrors(GetParam(), n, order, f).rms, fine = mappingErrors(GetParam(), 2*n, order, f).rms;
        Info<< "order " << order << ": errors " << coarse << ' ' << fine << ", measured order "
            << ::log2(coarse/fine) << endl;
        EXPECT_GT(::log2(coarse/fine), order + 0.5);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    remeshing, dimensions, ::testing::Values(2, 3),
    [](const auto& info) { return std::to_string(info.param) + "D"; }
);


TEST(remeshing, namesWhatIsWrong)
{
    const auto read = [](const char* text) { return dictionary(IStringStream(text)()); };
    const shapeMesh hexes("hex", {2, 2, 1}, [](const point& p) { return p; }, shapeMesh::twoD());
    const feMesh fe(hexes.mesh(), 1, dictionary());
    const auto select = [&](const char* text)
    {
        return complaint([&]() { remeshSelection(read(text)).check(fe); });
    };
    EXPECT_NE(select("").find("4 of the 4 cells that may be exchanged are no triangles"), std::string::npos);
    EXPECT_NE(select("cellZones (outer);").find("has no cellZone 'outer'"), std::string::npos);
    EXPECT_NE(select("extent some;").find("Unknown extent some. Valid: 2(all bad)"), std::string::npos);
    EXPECT_NE(select("layers -1;").find("layers is -1"), std::string::npos);

    const auto remesh = [&](const char* text)
    {
        return complaint([&]() { remesher::New(read(text), hexes.time()); });
    };
    EXPECT_NE(remesh("remesher none;").find("Unknown remesher none"), std::string::npos);
    EXPECT_NE(remesh("remesher CGAL; CGALCoeffs { iterations 0; }").find("iterations is 0"), std::string::npos);

    const auto criterion = [&](const char* text) { return complaint([&]() { remeshCriterion::New(read(text)); }); };
    EXPECT_NE(criterion("type never;").find("Unknown criterion type never"), std::string::npos);
    EXPECT_NE(criterion("type quality; interval 0;").find("interval is 0"), std::string::npos);
    EXPECT_NE(criterion("type inversion; steps -1;").find("steps is -1"), std::string::npos);
    EXPECT_NE(criterion("type times; interval -1;").find("interval is -1"), std::string::npos);

    const auto mapping = [&](const char* text) { return complaint([&]() { meshMapping::New(read(text)); }); };
    EXPECT_NE(mapping("mapping guess;").find("Unknown mapping type guess"), std::string::npos);
    EXPECT_NE(mapping("interpolationCoeffs { tolerance 0; }").find("tolerance is 0"), std::string::npos);
}


//- Of a mesh of cells that share no more than a point, or an edge, in 3-D
TEST(remeshing, saysWhyItCannot)
{
    const turnedMesh old(3, 2, 1, 0);
    const pointField& centres = old.box.mesh->cellCentres();
    DynamicList<label> cells;
    forAll(centres, c) if ((centres[c].x() < 0.5) == (centres[c].y() < 0.5)) cells.append(c);
    const exchangedMesh now(old, cells, [](const point&) { return 0.5; });
    EXPECT_NE(now.failure.find("meets itself"), std::string::npos) << now.failure;
}


int main(int argc, char* argv[])
{
    return runOnRanks(argc, argv);
}


// ************************************************************************* //
