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
#include "pinchedPoints.H"
#include "remesher.H"
#include "remeshMemory.H"
#include "simplexField.H"
#include "simplexQuality.H"
#include "remeshSelection.H"
#include "remeshCriteria.H"
#include "simplexExchange.H"
#include "meshMapping.H"
#include "emptyPolyPatch.H"
#include "IStringStream.H"
#include <chrono>
#include <random>

using namespace Foam;

namespace
{

//- Of triangles or tetrahedra, n to a side, turned by an angle in the middle
struct turnedMesh
{
    shapeMesh box;
    feMesh fe;

    turnedMesh(const label dim, const label n, const label order, const shapeMesh::pointMap& map)
    :
        box
        (
            dim == 2 ? "prism" : "tet", {n, n, dim == 2 ? 1 : n}, map,
            dim == 2 ? shapeMesh::twoD() : HashTable<word>()
        ),
        fe(box.mesh(), order, dictionary())
    {}

    turnedMesh(const label dim, const label n, const label order, const scalar angle = 1)
    :
        turnedMesh
        (
            dim, n, order,
            [=](const point& p)
            {
                const vector r(p.x() - 0.5, p.y() - 0.5, 0);
                const scalar z = dim == 2 ? 0.5 : p.z(), a = angle*max(1 - 2*mag(r), 0.0)*4*z*(1 - z);
                return point
                (
                    0.5 + r.x()*::cos(a) - r.y()*::sin(a), 0.5 + r.x()*::sin(a) + r.y()*::cos(a), p.z()
                );
            }
        )
    {}

    labelList all() const { return identity(box.mesh->nCells()); }
};


simplexMesh simplices(const turnedMesh& mesh)
{
    labelList nodes;
    return simplicesOf(mesh.fe, mesh.fe.points(), mesh.all(), nodes);
}


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


//- Two balls in a box of tetrahedra, each turned about its centre, the more the
//  nearer to it: the volume of no part changes
shapeMesh::pointMap twisted(std::mt19937& seed, const scalar most)
{
    std::uniform_real_distribution<scalar> any(0, 1);
    struct ball { point c; vector axis; scalar R, angle; };
    std::vector<ball> balls;
    for (label i = 0; i < 2; ++i)
    {
        const point c(0.3 + 0.4*any(seed), 0.3 + 0.4*any(seed), 0.3 + 0.4*any(seed));
        const vector axis(any(seed) - 0.5, any(seed) - 0.5, any(seed) - 0.5);
        const scalar wall = min(cmptMin(c), 1 - cmptMax(c));
        balls.push_back({c, axis/mag(axis), wall, most*(2*any(seed) - 1)});
    }
    return [=](const point& p)
    {
        point x(p);
        for (const ball& b : balls)
        {
            const vector r(x - b.c);
            const scalar a = b.angle*sqr(max(1 - mag(r)/b.R, scalar(0)));
            x = b.c + ::cos(a)*r + ::sin(a)*(b.axis ^ r) + (1 - ::cos(a))*(b.axis & r)*b.axis;
        }
        return x;
    };
}


//- Smallest angle between faces, degrees, and largest aspect ratio
struct shapes
{
    scalar angle = 180, aspectRatio = 0;

    explicit shapes(const feMesh& fe)
    {
        for (const auto& block : qualities(fe, fe.points())) for (const auto& q : block)
        {
            angle = min(angle, q.minAngle);
            aspectRatio = max(aspectRatio, q.aspectRatio);
        }
    }
};


//- Exchanges of all cells or of those in a ball, with a row of a table for each:
//  none fails, and points and faces of the boundary are the same, to the bit
void randomExchanges(const label nExchanges, const label nLeast, const label nMost)
{
    std::mt19937 seed(13);
    std::uniform_real_distribution<scalar> any(0, 1);
    Info<< "# exchange cells exchanged now angleBefore angle aspectRatioBefore aspectRatio seconds" << endl;
    for (label i = 0; i < nExchanges; ++i)
    {
        // Not so far that elements are inverted
        const label n = nLeast + label(any(seed)*(nMost - nLeast + 1));
        const std::mt19937 start(seed);
        autoPtr<turnedMesh> old;
        for (scalar most = 4; !old.valid(); most *= 0.7)
        {
            seed = start;
            const shapeMesh::pointMap map(twisted(seed, most));
            const shapeMesh box("tet", {n, n, n}, map);
            if (min(box.mesh->cellVolumes()) <= 0) continue;
            old.reset(new turnedMesh(3, n, 1, map));
            if (leastScaledJacobian(simplices(old())) < 0.01) old.clear();
        }
        const point centre(any(seed), any(seed), any(seed));
        const scalar radius = i % 2 ? GREAT : 0.3 + 0.5*any(seed);
        labelHashSet bad;
        const pointField& centres = old->box.mesh->cellCentres();
        forAll(centres, c) if (mag(centres[c] - centre) < radius) bad.insert(c);
        const labelList cells(remeshSelection(dictionary(IStringStream("extent bad; layers 0;")())).cells(old->fe, bad));

        const scalar regular = ::cbrt(::sqrt(2.0));
        const auto begin = std::chrono::steady_clock::now();
        const exchangedMesh now(old(), cells, [=](const point&) { return regular/n; });
        const scalar seconds = std::chrono::duration<scalar>(std::chrono::steady_clock::now() - begin).count();
        ASSERT_EQ(now.failure, "") << i;
        const shapes before(old->fe), after(now.fe());
        Info<< i << ' ' << centres.size() << ' ' << cells.size() << ' ' << now.mesh->nCells() << ' ' << before.angle << ' '
            << after.angle << ' ' << before.aspectRatio << ' ' << after.aspectRatio << ' ' << seconds << endl;
        EXPECT_NEAR(volume(now.mesh()), 1, 1e-12) << i;
        EXPECT_GT(after.angle, 1) << i;
        forAll(now.mesh->boundaryMesh(), patchi)
        {
            const polyPatch &a = old->box.mesh->boundaryMesh()[patchi], &b = now.mesh->boundaryMesh()[patchi];
            ASSERT_EQ(a.size(), b.size());
            forAll(a, f) EXPECT_EQ(a[f].points(old->box.mesh->points()), b[f].points(now.mesh->points()));
        }
    }
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


//- In a mesh with a hole, where a walk from cell to cell ends at its boundary
TEST_P(dimensions, findsValuesAnywhere)
{
    const turnedMesh whole(GetParam(), 9, 1, 0.5);
    DynamicList<label> cells;
    const pointField& centres = whole.box.mesh->cellCentres();
    forAll(centres, c) if (mag(centres[c].x() - 0.5) > 0.06 || centres[c].y() > 0.8) cells.append(c);
    labelList nodes;
    const simplexMesh mesh(simplicesOf(whole.fe, whole.fe.points(), cells, nodes));
    const auto f = [](const point& p) { return 1 + 2*p.x() - 3*p.y() + p.z(); };
    scalarField values(mesh.points.size());
    forAll(values, i) values[i] = f(mesh.points[i]);
    const simplexField field(mesh, values);
    std::mt19937 seed(1);
    for (const labelList& cell : mesh.cells)
    {
        point p = Zero;
        scalar sum = 0;
        for (const label v : cell)
        {
            const scalar w = std::uniform_real_distribution<scalar>(0, 1)(seed);
            p += w*mesh.points[v];
            sum += w;
        }
        EXPECT_NEAR(field(p/sum), f(p/sum), 1e-12);
    }

    // Outside of all cells the nearest value
    EXPECT_NEAR(field(point(0.3, -0.01, GetParam() == 2 ? 0 : 0.3)), f(point(0.3, 0, GetParam() == 2 ? 0 : 0.3)), 0.05);
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

//- An unchanged mesh exchanged again and again keeps its number of cells, also
//  where the cells are small in one place and large in another
TEST_P(dimensions, keepsTheNumberOfCells)
{
    const label dim = GetParam(), n = dim == 2 ? 20 : 6;
    const dictionary dict(IStringStream("remesher CGAL;")());
    for (const scalar grading : {0.0, 0.8})
    {
        const turnedMesh old
        (
            dim, n, 1, [=](const point& p) { return point(p.x()*(1 - grading*(1 - p.x())), p.y(), p.z()); }
        );
        labelList nodes;
        const simplexMesh first(simplicesOf(old.fe, old.fe.points(), old.all(), nodes));
        scalarField sizes(cellSizes(old.fe), nodes);
        simplexMesh mesh(first);
        for (label i = 0; i < 3; ++i)
        {
            const simplexField size(mesh, sizes);
            simplexMesh now(mesh);
            ASSERT_EQ(remesher::New(dict, old.box.time())->remesh(mesh, size, now), "");

            // As in a run sizes go on from mesh to mesh
            sizes.setSize(now.points.size());
            forAll(sizes, p) sizes[p] = size(now.points[p]);
            mesh = now;
            Info<< "grading " << grading << ": " << first.cells.size() << " -> " << mesh.cells.size()
                << " cells, worst scaled Jacobian " << leastScaledJacobian(mesh) << endl;
        }
        EXPECT_NEAR(mesh.cells.size(), first.cells.size(), (dim == 2 ? 0.1 : 0.2)*first.cells.size());
    }
}


INSTANTIATE_TEST_SUITE_P
(
    remeshing, dimensions, ::testing::Values(2, 3),
    [](const auto& info) { return std::to_string(info.param) + "D"; }
);


TEST(remeshing, randomExchanges) { randomExchanges(4, 4, 7); }

//- regression/randomExchanges
TEST(remeshing, DISABLED_manyRandomExchanges) { randomExchanges(100, 10, 25); }


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


//- A selection of such cells has those around the edge, too
TEST(remeshing, selectsWhatCanBeExchanged)
{
    const turnedMesh old(3, 3, 1, 0);
    const pointField& centres = old.box.mesh->cellCentres();
    labelHashSet bad;
    forAll(centres, c)
    {
        if (cmptMax(centres[c]) < 1.0/3) bad.insert(c);
        if (max(centres[c].x(), centres[c].y()) < 2.0/3 && cmptMin(centres[c]) > 1.0/3) bad.insert(c);
    }
    labelList nodes;
    const labelList asked(bad.sortedToc());
    const auto pinched = [&](const labelList& cells)
    {
        return pinchedPoints(simplicesOf(old.fe, old.fe.points(), cells, nodes)).size();
    };
    EXPECT_EQ(pinched(asked), 1);
    const labelList cells(remeshSelection(dictionary(IStringStream("extent bad; layers 0;")())).cells(old.fe, bad));
    EXPECT_GT(cells.size(), asked.size());
    EXPECT_LT(cells.size(), centres.size());
    EXPECT_EQ(pinched(cells), 0);
    const exchangedMesh now(old, cells, [](const point&) { return 0.3; });
    EXPECT_EQ(now.failure, "");
}


int main(int argc, char* argv[])
{
    return runOnRanks(argc, argv);
}


// ************************************************************************* //
