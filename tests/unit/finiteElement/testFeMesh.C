/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the finite-element view of meshes that are made in memory.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "feMesh.H"
#include "feValues.H"
#include "IStringStream.H"
#include "mathematicalConstants.H"
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <set>

using namespace Foam;

namespace
{

//- Distorts the interior and the sides, in the plane only
point distorted(const point& p)
{
    return point
    (
        p.x() + 0.3*p.y() + 0.1*::sin(3*p.y() + 2*p.x()),
        p.y() - 0.2*p.x() + 0.08*::sin(4*p.x()),
        0.25*p.z()
    );
}

dictionary entries(const string& text)
{
    IStringStream is(text);
    return dictionary(is);
}

//- The message of the error that f makes
template<class F>
std::string complaint(const F& f)
{
    const bool throwing = FatalError.throwExceptions(), ioThrowing = FatalIOError.throwExceptions();
    std::string message;
    try { f(); }
    catch (const Foam::IOerror& error) { message = error.message(); }
    catch (const Foam::error& error) { message = error.message(); }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(ioThrowing);
    return message;
}

#define EXPECT_HAS(message, part) \
    EXPECT_NE(message.find(part), std::string::npos) << message

//- Mass and Laplace matrices of a mesh
struct matrices
{
    Eigen::MatrixXd M, L;
    scalar volume = 0;

    explicit matrices(const feMesh& fe)
    :
        M(Eigen::MatrixXd::Zero(fe.nNodes(), fe.nNodes())),
        L(M)
    {
        for (const elementBlock& block : fe.blocks())
        {
            withElement(block, [&](auto tag)
            {
                typedef decltype(tag) E;
                feValues<double, E> w;
                Vec<double, E::dim> x[E::nNodes];
                for (label e = 0; e < block.size(); ++e)
                {
                    const label* n = block.element(e);
                    for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                    {
                        x[i][a] = fe.points()[n[i]][fe.axis(a)];
                    }
                    for (int q = 0; q < w.nQ; ++q)
                    {
                        w.reinit(x, q);
                        volume += w.dV;
                        for (int i = 0; i < E::nNodes; ++i) for (int j = 0; j < E::nNodes; ++j)
                        {
                            M(n[i], n[j]) += w.N[i]*w.N[j]*w.dV;
                            L(n[i], n[j]) += (w.dN[i] & w.dN[j])*w.dV;
                        }
                    }
                }
            });
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(feMesh, planeViewIsALayerOfTheSpaceView)
{
    for (const word cell : {"hex", "prism"}) for (const label order : {1, 2})
    {
        // Prisms have no order 2: there the plane alone
        if (cell == "prism" && order == 2) continue;
        SCOPED_TRACE(cell + " of order " + std::to_string(order));

        const FixedList<label, 3> n({4, 3, 1});
        const shapeMesh plane(cell, n, distorted, shapeMesh::twoD());
        const shapeMesh layer(cell, n, distorted);
        const feMesh fe2(plane.mesh(), order, dictionary()), fe3(layer.mesh(), order, dictionary());
        EXPECT_EQ(fe2.dim(), 2);
        EXPECT_EQ(fe3.dim(), 3);
        EXPECT_EQ(fe2.nElements(), fe3.nElements());
        EXPECT_EQ((order + 1)*fe2.nNodes(), fe3.nNodes());
        EXPECT_EQ(2*fe2.nVertices(), fe3.nVertices());

        // P: to the nodes of the layer from those of the plane
        Eigen::MatrixXd P = Eigen::MatrixXd::Zero(fe3.nNodes(), fe2.nNodes());
        forAll(fe3.points(), i) forAll(fe2.points(), j)
        {
            vector d = fe3.points()[i] - fe2.points()[j];
            d.z() = 0;
            if (mag(d) < 1e-10) P(i, j) = 1;
        }
        EXPECT_EQ(P.sum(), fe3.nNodes());

        const matrices A(fe2), B(fe3);
        const scalar depth = 0.25;
        EXPECT_NEAR(depth*A.volume, B.volume, 1e-14);
        EXPECT_LT((depth*A.M - P.transpose()*B.M*P).norm(), 1e-14*B.M.norm());
        EXPECT_LT((depth*A.L - P.transpose()*B.L*P).norm(), 1e-13*B.L.norm());
        EXPECT_NEAR(A.volume*depth, gSum(plane.mesh->cellVolumes()), 1e-3);
    }
}


TEST(feMesh, trianglesOfOrderTwoKnowTheirArea)
{
    const shapeMesh plane("prism", {4, 3, 1}, distorted, shapeMesh::twoD());
    const feMesh fe(plane.mesh(), 2, dictionary());
    EXPECT_EQ(fe.nNodes(), 9*7);
    EXPECT_NEAR(0.25*matrices(fe).volume, gSum(plane.mesh->cellVolumes()), 1e-14);
}


TEST(feMesh, anyDirectionMayBeEmpty)
{
    const char* sides[3][2] = {{"left", "right"}, {"bottom", "top"}, {"back", "front"}};
    const FixedList<label, 3> counts[3] = {{1, 3, 2}, {3, 1, 2}, {3, 2, 1}};
    for (label a = 0; a < 3; ++a)
    {
        HashTable<word> types;
        types.set(sides[a][0], "empty");
        types.set(sides[a][1], "empty");
        const shapeMesh box
        (
            "hex", counts[a],
            [](const point& p) { return point(2*p.x(), 3*p.y(), 5*p.z()); }, types
        );
        const feMesh fe(box.mesh(), 2, dictionary());
        EXPECT_EQ(fe.axis(2), a);
        EXPECT_EQ(fe.nNodes(), 7*5);
        const scalar size[] = {2, 3, 5};
        EXPECT_NEAR(matrices(fe).volume, 30/size[a], 1e-12);
        EXPECT_NEAR(fe.meanSize(), ::sqrt(30/size[a]/6), 1e-12);
    }
}


TEST(feMesh, allCellsOfSpace)
{
    struct { const char* cell; label order, nElements, nNodes; } meshes[] =
    {
        {"hex", 1, 12, 36}, {"hex", 2, 12, 7*5*5}, {"tet", 1, 72, 36}, {"tet", 2, 72, 7*5*5},
        {"prism", 1, 24, 36}, {"pyr", 1, 72, 48}
    };
    for (const auto& m : meshes)
    {
        SCOPED_TRACE(m.cell);
        const shapeMesh box(m.cell, {3, 2, 2}, [](const point& p) { return point(p.x(), p.y() + 0.2*p.x(), 2*p.z()); });
        const feMesh fe(box.mesh(), m.order, dictionary());
        EXPECT_EQ(fe.nElements(), m.nElements);
        EXPECT_EQ(fe.nNodes(), m.nNodes);
        EXPECT_NEAR(matrices(fe).volume, 2, 1e-13);

        // Faces of the patches look outwards; a closed surface has area nil
        Vec<double, 3> area = Vec<double, 3>::zero();
        double flux = 0;
        forAll(box.mesh->boundaryMesh(), patchi) for (const elementBlock& block : fe.patchBlocks(patchi))
        {
            withFaceElement(block, [&](auto tag)
            {
                typedef decltype(tag) F;
                if constexpr (F::dim == 2)
                {
                    faceValues<double, F> face;
                    Vec<double, 3> x[F::nNodes];
                    for (label e = 0; e < block.size(); ++e)
                    {
                        for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < 3; ++a)
                        {
                            x[i][a] = fe.points()[block.element(e)[i]][a];
                        }
                        for (int q = 0; q < face.nQ; ++q)
                        {
                            face.reinit(x, q);
                            area += face.ndA;
                            flux += face.value(x) & face.ndA;
                        }
                    }
                }
            });
        }
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(area[a], 0, 1e-13);
        EXPECT_NEAR(flux, 3*2, 1e-12);
    }
}


TEST(feMesh, chunksOfAColourShareNoNode)
{
    for (const word cell : {"hex", "prism", "tet", "pyr"}) for (const label order : {1, 2})
    {
        if (order == 2 && (cell == "prism" || cell == "pyr")) continue;
        const shapeMesh box(cell, {5, 4, 3});
        const feMesh fe(box.mesh(), order, dictionary());
        for (const elementBlock& block : fe.blocks())
        {
            labelList visits(block.nBatches(), 0);
            for (const labelList& colour : block.colours)
            {
                std::vector<label> ownerOf(fe.nNodes(), -1);
                for (const label chunk : colour) block.forBatches(chunk, [&](const label batch)
                {
                    ++visits[batch];
                    for (int l = 0; l < block.nLanes(batch); ++l) for (label i = 0; i < block.nNodes; ++i)
                    {
                        label& owner = ownerOf[block.element(block.lane(batch, l))[i]];
                        EXPECT_TRUE(owner == -1 || owner == chunk);
                        owner = chunk;
                    }
                });
            }
            EXPECT_EQ(min(visits), 1);
            EXPECT_EQ(max(visits), 1);
            label last = 0;
            for (int l = 0; l < packSize; ++l) last = max(last, block.lane(block.nBatches() - 1, l));
            EXPECT_EQ(last, block.size() - 1);
        }
    }
}


//- More colours than there are bits: a fan of elements around one node
TEST(feMesh, aNodeOfManyElementsHasManyColours)
{
    elementBlock fan;
    fan.shape = elementShape::TRI;
    fan.order = 1;
    fan.nNodes = 3;
    const label n = 80*packSize;
    fan.cells = identity(n);
    fan.nodes.setSize(3*n);
    for (label e = 0; e < n; ++e)
    {
        fan.nodes[3*e] = 0;
        fan.nodes[3*e + 1] = 1 + e;
        fan.nodes[3*e + 2] = 1 + (e + 1)%n;
    }
    fan.colour(n + 1);
    label batches = 0;
    for (const labelList& colour : fan.colours)
    {
        EXPECT_EQ(colour.size(), 1);
        batches += colour.size();
    }
    EXPECT_EQ(batches, 80);
}


//- Quarter of an annulus: x is the radius, y the angle
TEST(feMesh, curvedPatchesLieOnTheirSurface)
{
    const auto annulus = [](const point& p)
    {
        const scalar r = 1 + p.x(), angle = 0.5*constant::mathematical::pi*p.y();
        return point(r*::cos(angle), r*::sin(angle), 0.25*p.z());
    };
    const dictionary dict = entries
    (
        "curvedPatches { left { type searchableCylinder; point1 (0 0 -1); point2 (0 0 2); radius 1; }"
        " right { type searchableCylinder; point1 (0 0 -1); point2 (0 0 2); radius 2; } }"
    );
    for (const bool plane : {true, false}) for (const word cell : {"hex", "prism", "tet"})
    {
        if (!plane && cell == "prism") continue;
        if (plane && cell == "tet") continue;
        SCOPED_TRACE(cell + (plane ? ", plane" : ", space"));
        const shapeMesh mesh
        (
            cell, {2, 4, 1}, annulus, plane ? shapeMesh::twoD() : HashTable<word>()
        );
        const feMesh fe(mesh.mesh(), 2, dict);
        scalar error = 0;
        for (const char* side : {"left", "right"})
        {
            const label patchi = mesh.mesh->boundaryMesh().findPatchID(side);
            EXPECT_EQ(fe.patchNodes(patchi).size(), plane ? 9 : 27);
            for (const label i : fe.patchNodes(patchi))
            {
                const vector& x = fe.points()[i];
                const scalar r = ::sqrt(sqr(x.x()) + sqr(x.y()));

                // Diagonals of triangles cross the arc at the height of their
                // middle: there, too
                error = max(error, mag(r - (patchi == 0 ? 1 : 2)));
            }
        }
        EXPECT_LT(error, 1e-12);

        const scalar exact = 0.25*constant::mathematical::pi*3*(plane ? 1 : 0.25);
        const scalar curved = matrices(fe).volume, straight = matrices(feMesh(mesh.mesh(), 2, dictionary())).volume;
        EXPECT_NEAR(curved, exact, 5e-4*exact);
        EXPECT_GT(mag(straight - exact), 0.02*exact);
    }
}


TEST(feMesh, curvedPatchesComplain)
{
    const shapeMesh plane("hex", {2, 2, 1}, distorted, shapeMesh::twoD());
    const auto with = [&](const string& text)
    {
        return complaint([&]() { feMesh(plane.mesh(), 2, entries("curvedPatches {" + text + "}")); });
    };
    const std::string noPatch = with("wall { type searchableSphere; centre (0 0 0); radius 1; }");
    EXPECT_HAS(noPatch, "no patch 'wall'");
    EXPECT_HAS(noPatch, "bottom");
    const std::string far = with("left { type searchableSphere; centre (9 0 0); radius 1; }");
    EXPECT_HAS(far, "mid-side node");
}


TEST(feMesh, interpolatesLinearFieldsAndMovesPoints)
{
    const tensor A(1, 2, 3, -1, 0.5, 2, 0.3, 0.7, -2);
    for (const word cell : {"hex", "tet", "prism"})
    {
        const bool plane = cell == "prism";
        const shapeMesh box(cell, {2, 2, 1}, distorted, plane ? shapeMesh::twoD() : HashTable<word>());
        const feMesh fe(box.mesh(), 2, dictionary());
        const pointField& X = box.mesh->points();
        const vectorField u(fe.interpolate<vector>(vectorField(A & X)));
        forAll(u, i) EXPECT_LT(mag(u[i] - (A & fe.points()[i])), 1e-13);

        const pointField moved(fe.movedPoints(u));
        forAll(moved, p)
        {
            const vector d = u[fe.pointNode()[p]];
            EXPECT_LT(mag(moved[p] - X[p] - vector(d.x(), d.y(), plane ? 0 : d.z())), 1e-13);
        }

        vectorField back(X.size(), Zero);
        fe.toPoints<vector>(u, back);
        if (plane) continue;
        forAll(back, p) EXPECT_LT(mag(back[p] - (A & X[p])), 1e-13);
    }
}


TEST(feMesh, patchesByNameGroupAndPattern)
{
    const shapeMesh box("hex", {2, 1, 1}, distorted, shapeMesh::twoD());
    const polyBoundaryMesh& patches = box.mesh().boundaryMesh();
    for (const word name : {"left", "top"})
    {
        const_cast<polyPatch&>(patches[name]).inGroups() = wordList({"held"});
    }
    const feMesh fe(box.mesh(), 1, dictionary());
    const auto of = [&](const string& list)
    {
        return fe.patchIndices(entries("patches " + list + ";").get<wordRes>("patches"), dictionary::null);
    };
    const auto indices = [&](const wordList& names)
    {
        labelList i;
        for (const word& name : names) i.append(patches.findPatchID(name));
        Foam::sort(i);
        return i;
    };
    EXPECT_EQ(of("(left right)"), indices({"left", "right"}));
    EXPECT_EQ(of("(held)"), indices({"left", "top"}));
    EXPECT_EQ(of("(held \"(l|r).*\" left)"), indices({"left", "right", "top"}));

    EXPECT_HAS(complaint([&]() { of("()"); }), "The list of patches is empty");
    const std::string message(complaint([&]() { of("(left heldd)"); }));
    EXPECT_HAS(message, "no patch 'heldd'");
    EXPECT_HAS(message, "left");
    EXPECT_HAS(message, "its groups");
    EXPECT_HAS(message, "held");
}


TEST(feMesh, complainsOfInvertedCells)
{
    // A concave corner, and a cell whose area is negative
    for (const scalar c : {0.9, 1.6}) for (const label order : {1, 2})
    {
        const auto tangled = [c](const point& p)
        {
            return mag(p - point(0.5, 0.5, p.z())) < 0.01 ? point(c, c, p.z()) : p;
        };
        const shapeMesh plane("hex", {2, 2, 1}, tangled, shapeMesh::twoD());
        const std::string message = complaint([&]() { feMesh(plane.mesh(), order, dictionary()); });
        EXPECT_HAS(message, "is inverted");
        EXPECT_HAS(message, c < 1 ? "Cell 3 (quad" : "Cell 1 (quad");
    }

    const shapeMesh solid("tet", {2, 2, 2}, [](const point& p)
    {
        return mag(p - point(0.5, 0.5, 0.5)) < 0.01 ? point(1.6, 1.6, 1.6) : p;
    });
    EXPECT_HAS(complaint([&]() { feMesh(solid.mesh(), 1, dictionary()); }), "is inverted");
}


TEST(feMesh, complainsOfOrderTwoWhereThereIsNone)
{
    const shapeMesh box("prism", {1, 1, 1});
    EXPECT_HAS(complaint([&]() { feMesh(box.mesh(), 2, dictionary()); }), "no element of order 2");
}


//- A hexagonal prism
TEST(feMesh, complainsOfOtherCells)
{
    for (const bool plane : {false, true})
    {
        pointField points(12);
        faceList faces(8, face(4));
        faces[0] = face(identity(6));
        faces[1] = face(6);
        for (label i = 0; i < 6; ++i)
        {
            const scalar angle = constant::mathematical::pi*i/3;
            points[i] = point(::cos(angle), ::sin(angle), 1);
            points[i + 6] = points[i] - point(0, 0, 1);
            faces[1][i] = 6 + (6 - i)%6;
            const label j = (i + 1)%6;
            faces[2 + i] = face(labelList({i, i + 6, j + 6, j}));
        }
        const autoPtr<Time> time = Time::New();
        polyMesh mesh
        (
            IOobject("hexagon", time->constant(), time(), IOobject::NO_READ),
            std::move(points), std::move(faces), labelList(8, 0), labelList(), false
        );
        List<polyPatch*> patches(2);
        patches[0] = polyPatch::New(plane ? "empty" : "patch", "ends", 2, 0, 0, mesh.boundaryMesh()).ptr();
        patches[1] = polyPatch::New("patch", "sides", 6, 2, 1, mesh.boundaryMesh()).ptr();
        mesh.addPatches(patches);

        const std::string message = complaint([&]() { feMesh(mesh, 1, dictionary()); });
        EXPECT_HAS(message, "Cell 0 of region hexagon at");
        EXPECT_HAS(message, plane ? "an empty face of 6 corners" : "is of type 'unknown' with 8 faces");
    }
}


// ************************************************************************* //
