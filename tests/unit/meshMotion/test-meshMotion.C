/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-meshMotion

Description
    Tests of the mesh motion on meshes in memory.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "runOnRanks.H"
#include "feMesh.H"
#include "laplaceMotion.H"
#include "meshStiffness.H"
#include "IStringStream.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

dictionary entries(const string& text)
{
    IStringStream is(text);
    return dictionary(is);
}

const tensor gradient(0.1, -0.2, 0.05, 0.3, 0.05, -0.1, 0.02, 0.1, -0.15);

point distorted(const point& p)
{
    return point(1.2*p.x() + 0.2*p.y() + 0.04*::sin(7*p.y()), p.y() + 0.05*::sin(5*p.x()), 0.8*p.z());
}

//- A mesh and its motion; each direction of the depth is held or empty
struct motionCase
{
    shapeMesh box;
    feMesh fe;
    autoPtr<laplaceMotion> motion;

    motionCase
    (
        const word& cell, const label order, const bool plane, const string& dict,
        const shapeMesh::pointMap& map = distorted,
        const HashTable<word>& types = HashTable<word>()
    )
    :
        box(cell, {4, 3, plane ? 1 : 2}, map, both(types, plane)),
        fe(box.mesh(), order, dictionary())
    {
        motion.reset(new laplaceMotion(fe, nullptr, labelList(), entries(dict), entries("type MUMPS;")));
    }

    static HashTable<word> both(HashTable<word> types, const bool plane)
    {
        if (plane) types += shapeMesh::twoD();
        return types;
    }

    //- In the directions of the case
    vector inPlane(vector v) const
    {
        if (fe.dim() == 2) v.z() = 0;
        return v;
    }

    //- Extend the boundary values of a function of the position
    template<class F>
    vectorField extend(const F& f) const
    {
        vectorField u(fe.nNodes(), Zero);
        forAll(u, n) if (motion->given(n)) u[n] = inPlane(f(fe.points()[n]));
        motion->extend(u);
        return u;
    }

    label nGiven() const
    {
        label n = 0;
        for (label i = 0; i < fe.nNodes(); ++i) n += motion->given(i);
        return n;
    }
};

//- Call f(case) for all kinds of elements
template<class F>
void forMeshes(const string& dict, const F& f)
{
    const auto test = [&](const char* cell, const label order, const bool plane)
    {
        SCOPED_TRACE(std::string(cell) + " of order " + std::to_string(order) + (plane ? ", plane" : ""));
        f(motionCase(cell, order, plane, dict));
    };
    for (const char* cell : {"hex", "prism"}) for (const label order : {1, 2}) test(cell, order, true);
    for (const char* cell : {"hex", "tet"}) for (const label order : {1, 2}) test(cell, order, false);
    test("prism", 1, false);
    test("pyr", 1, false);
}

template<class F>
std::string complaint(const F& f)
{
    const bool throwing = FatalIOError.throwExceptions();
    std::string message;
    try { f(); }
    catch (const Foam::IOerror& error) { message = error.message(); }
    FatalIOError.throwExceptions(throwing);
    return message;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(laplaceMotion, reproducesLinearDisplacements)
{
    forMeshes("stiffness uniform;", [](const motionCase& c)
    {
        const auto linear = [&](const point& x) { return c.inPlane(vector(1, 2, 3) + (gradient & x)); };
        EXPECT_LT(c.nGiven(), c.fe.nNodes());
        const vectorField u(c.extend(linear));
        forAll(u, n) EXPECT_LT(mag(u[n] - linear(c.fe.points()[n])), 1e-12);
    });
}


//- A translation is kept by any stiffness; the largest displacement is on the
//  boundary; the map is linear
TEST(laplaceMotion, everyStiffnessKeepsTranslations)
{
    for (const word& type : meshStiffness::dictionaryConstructorTablePtr_->sortedToc())
    {
        SCOPED_TRACE(type);
        forMeshes("stiffness " + type + "; exponent 1.5; patches (left);", [&](const motionCase& c)
        {
            const vector v = c.inPlane(vector(0.3, -2, 0.7));
            const vectorField u(c.extend([&](const point&) { return v; }));
            forAll(u, n) EXPECT_LT(mag(u[n] - v), 1e-12);

            const List<scalarField> kappa = meshStiffness::elements
            (
                c.fe, entries("stiffness " + type + "; exponent 1.5; patches (left);")
            );
            label nElements = 0;
            for (const scalarField& k : kappa)
            {
                nElements += k.size();
                for (const scalar s : k) EXPECT_TRUE(s > 0 && std::isfinite(s)) << s;
            }
            EXPECT_EQ(nElements, c.fe.nElements());
        });
    }
}


TEST(laplaceMotion, aClosedCycleReturnsToNil)
{
    forMeshes("stiffness inverseVolume;", [](const motionCase& c)
    {
        // Each position has its own displacement, however it was reached
        vectorField u(c.fe.nNodes(), Zero), early;
        for (label step = 0; step <= 8; ++step)
        {
            const scalar s = ::sin(0.25*constant::mathematical::pi*(step % 8));
            forAll(u, n) if (c.motion->given(n)) u[n] = s*c.inPlane(gradient & c.fe.points()[n]);
            c.motion->extend(u);
            if (step == 1) early = u;
            if (step != 3) continue;
            forAll(u, n) EXPECT_LT(mag(u[n] - early[n]), 1e-14);
        }
        forAll(u, n) EXPECT_EQ(u[n], vector::zero);
    });
}


//- The nodes of a symmetry patch stay in its plane and slide there, those of
//  the edges of two planes along the edge
TEST(laplaceMotion, nodesSlideOnSymmetryPatches)
{
    const scalar angle = 0.4;
    const auto turned = [&](const point& p)
    {
        return point(::cos(angle)*p.x() - ::sin(angle)*p.y(), ::sin(angle)*p.x() + ::cos(angle)*p.y(), 0.5*p.z());
    };
    const vector along(::cos(angle), ::sin(angle), 0), normal(-::sin(angle), ::cos(angle), 0);
    for (const bool plane : {true, false}) for (const label order : {1, 2})
    {
        HashTable<word> types;
        types.set("bottom", "symmetryPlane");
        if (!plane)
        {
            types.set("back", "symmetryPlane");
            types.set("front", "symmetry");
        }
        const motionCase c("hex", order, plane, "stiffness uniform;", turned, types);

        // Stretched along the plane: exact, with uniform stiffness
        const vectorField u(c.extend([&](const point& x) { return (0.1*(along & x))*along; }));
        forAll(u, n)
        {
            EXPECT_LT(mag(u[n] - (0.1*(along & c.fe.points()[n]))*along), 1e-13);
        }

        // Top moves up: the bottom stays in its plane
        const vectorField v(c.extend([&](const point& x) { return (0.2*sqr(normal & x))*(normal + 0.5*along); }));
        const label bottom = c.box.mesh->boundaryMesh().findPatchID("bottom");
        scalar slip = 0;
        for (const label n : c.fe.patchNodes(bottom))
        {
            EXPECT_NEAR(v[n] & normal, 0, 1e-13);
            slip = max(slip, mag(v[n] & along));
            EXPECT_NEAR(v[n].z(), 0, 1e-13);
        }
        EXPECT_GT(slip, 1e-3);
    }
}


TEST(meshStiffness, isOfTheMeasureItSays)
{
    // Cells of sizes 1 : 2 along x
    const auto graded = [](const point& p) { return point(p.x() < 0.6 ? p.x() : 0.5 + 2*(p.x() - 0.5), p.y(), p.z()); };
    const shapeMesh box("hex", {2, 1, 1}, graded, shapeMesh::twoD());
    const feMesh fe(box.mesh(), 1, dictionary());
    const auto ratio = [&](const string& dict)
    {
        const scalarField k(meshStiffness::elements(fe, entries(dict))[0]);
        return k[0]/k[1];
    };
    EXPECT_NEAR(ratio("stiffness uniform;"), 1, 1e-14);
    EXPECT_NEAR(ratio("stiffness inverseVolume;"), 2, 1e-12);
    EXPECT_NEAR(ratio("stiffness inverseVolume; exponent 2;"), 4, 1e-12);
    EXPECT_NEAR(ratio(""), 2, 1e-12);

    // Centres (0.25 0.5) and (1 0.5), the patch's nodes (0 0) and (0 1)
    EXPECT_NEAR(ratio("stiffness inverseDistance; patches (left);"), 2, 1e-12);
    EXPECT_NEAR(ratio("stiffness inverseDistance; patches (left); exponent 3;"), 8, 1e-11);

    // l^2/V: sides 0.5 x 1 and 1 x 1
    EXPECT_NEAR(ratio("stiffness distortion;"), (0.3125/0.5)/(0.5/1), 1e-12);
}


TEST(meshStiffness, complains)
{
    const shapeMesh box("hex", {2, 1, 1}, distorted, shapeMesh::twoD());
    const feMesh fe(box.mesh(), 1, dictionary());
    const auto of = [&](const string& dict)
    {
        return complaint([&]() { meshStiffness::elements(fe, entries(dict)); });
    };
    EXPECT_NE(of("stiffness soft;").find("inverseDistance"), std::string::npos) << of("stiffness soft;");
    EXPECT_NE(of("zones { near 3; }").find("no cellZone 'near'"), std::string::npos);
    EXPECT_NE(of("stiffness inverseDistance; patches (flag);").find("no patch 'flag'"), std::string::npos);
    EXPECT_NE(of("exponent 1e3;").find("from 0 to 10"), std::string::npos);
}


TEST(meshStiffness, factorsOfZones)
{
    const shapeMesh box("hex", {2, 1, 1}, distorted, shapeMesh::twoD());
    polyMesh& mesh = const_cast<polyMesh&>(box.mesh());
    mesh.addZones
    (
        List<pointZone*>(), List<faceZone*>(),
        List<cellZone*>(1, new cellZone("near", labelList(1, 0), 0, mesh.cellZones()))
    );
    const feMesh fe(mesh, 1, dictionary());
    const scalarField k(meshStiffness::elements(fe, entries("stiffness uniform; zones { near 3; }"))[0]);
    EXPECT_EQ(k[0], 3);
    EXPECT_EQ(k[1], 1);

    for (const string factor : {"0", "-2", "{}"})
    {
        const string dict("zones { near " + factor + (factor == "{}" ? "" : ";") + " }");
        const std::string message(complaint([&]() { meshStiffness::elements(fe, entries(dict)); }));
        EXPECT_NE(message.find("cellZone near under zones is no number > 0"), std::string::npos) << message;
    }
}


int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //
