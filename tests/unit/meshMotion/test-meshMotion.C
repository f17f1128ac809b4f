/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-meshMotion

Description
    Tests of the mesh motion on meshes in memory.
\*---------------------------------------------------------------------------*/

#include "complaint.H"
#include "shapeMesh.H"
#include "runOnRanks.H"
#include "feMesh.H"
#include "meshMotion.H"
#include "meshStiffness.H"
#include "elementQuality.H"
#include "nodalBoundary.H"
#include "nodalSurface.H"
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
    mutable autoPtr<meshMotion> motion;

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
        motion = meshMotion::New(fe, nullptr, labelList(), coeffs(dict), entries("type MUMPS;"));
    }

    //- A dynamicMeshDict: of feLaplacian if it names no motionSolver
    static dictionary coeffs(const string& dict)
    {
        dictionary all, coeffs(entries(dict));
        const word type(coeffs.getOrDefault<word>("motionSolver", "feLaplacian"));
        all.add("motionSolver", type);
        all.add(word(type + "Coeffs"), coeffs);
        return all;
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

    //- Steps in which the boundary has the values of a function
    template<class F>
    void steps(const label n, const F& f, vectorField& u) const
    {
        for (label k = 0; k < n; ++k)
        {
            motion->adapt(u);
            forAll(u, i) if (motion->given(i)) u[i] = inPlane(f(fe.points()[i]));
            ASSERT_TRUE(motion->extend(u));
        }
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

//- Call f(dictionary) for all operators in all configurations that they have
template<class F>
void forOperators(const F& f)
{
    for (const word& type : meshMotion::dictionaryConstructorTablePtr_->sortedToc())
    {
        const string solver("motionSolver " + type + "; stiffness uniform; ");
        SCOPED_TRACE(type);
        f(solver + (type == "feElasticity" ? "model linear; poissonRatio 0.2;" : ""));
        f(solver + (type == "feElasticity" ? "model linear;" : "") + "configuration incremental;");
        if (type == "feElasticity") f(solver + "model neoHookean; poissonRatio 0.2;");
    }
}

//- Stiffness of the elements as a dictionary says
List<scalarField> stiffness(const feMesh& fe, const string& dict, const motionWalls& walls = motionWalls())
{
    return meshStiffness::New(fe, walls, entries(dict), {})->elements(fe.points());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- A homogeneous deformation is in equilibrium with uniform stiffness
TEST(meshMotion, reproducesLinearDisplacements)
{
    forOperators([](const string& dict)
    {
        forMeshes(dict, [](const motionCase& c)
        {
            const auto linear = [&](const point& x) { return c.inPlane(vector(1, 2, 3) + (gradient & x)); };
            EXPECT_LT(c.nGiven(), c.fe.nNodes());
            vectorField u(c.fe.nNodes(), Zero);
            c.steps(8, linear, u);
            forAll(u, n) EXPECT_LT(mag(u[n] - linear(c.fe.points()[n])), 1e-11);
        });
    });
}


//- Within a step the increments are the exact derivative
TEST(meshMotion, incrementsAreTheTangent)
{
    forOperators([](const string& dict)
    {
        const motionCase c("hex", 2, true, dict);
        const auto bent = [](const point& x) { return vector(0.1*sqr(x.y()), -0.1*x.x()*x.y(), 0); };
        const auto further = [](const point& x) { return vector(x.y(), sqr(x.x()), 0); };
        vectorField u(c.fe.nNodes(), Zero);
        c.steps(2, bent, u);
        c.motion->adapt(u);
        vectorField one(u), two(u), du(u.size(), Zero);
        forAll(u, n) if (c.motion->given(n))
        {
            du[n] = further(c.fe.points()[n]);
            two[n] += 0.01*du[n];
        }
        c.motion->extend(one);
        c.motion->extend(two);
        c.motion->extendIncrement(du);
        forAll(u, n) EXPECT_LT(mag(two[n] - one[n] - 0.01*du[n]), 1e-13);
    });
}


//- A boundary that returns brings all nodes back, but for the incremental
//  configuration
TEST(meshMotion, aClosedCycleReturns)
{
    forOperators([](const string& dict)
    {
        const motionCase c("hex", 1, true, dict + "update no;");
        vectorField u(c.fe.nNodes(), Zero);
        for (label step = 0; step <= 12; ++step)
        {
            const scalar a = constant::mathematical::pi*step/6;
            const auto at = [&](const point& x)
            {
                return 0.2*vector(::sin(a)*sqr(x.y()), (1 - ::cos(a))*sqr(x.x())*x.y(), 0);
            };
            c.steps(step == 12 ? 6 : 1, at, u);
        }
        scalar drift = 0;
        forAll(u, n) drift = max(drift, mag(u[n]));
        if (dict.find("incremental") == std::string::npos) EXPECT_LT(drift, 1e-10);
        else EXPECT_GT(drift, 1e-5);
    });
}


//- The neo-Hookean mesh is kept where a Laplacian inverts elements: a side moves
//  across 0.9 of the box
TEST(meshMotion, neoHookeanGoesFurther)
{
    const auto largest = [](const string& dict)
    {
        const motionCase c("hex", 1, true, dict, [](const point& p) { return p; });
        const label left = c.box.mesh->boundaryMesh().findPatchID("left");
        labelHashSet moved(c.fe.patchNodes(left));
        vectorField u(c.fe.nNodes(), Zero);
        for (label step = 1; step <= 50; ++step)
        {
            c.motion->adapt(u);
            for (const label n : moved) u[n].x() = 0.018*step*c.fe.points()[n].y()*(1 - c.fe.points()[n].y())*4;
            c.motion->extend(u);
            if (forecast(c.fe, c.fe.points() + u, vectorField()).steps <= 0) return step;
        }
        return label(51);
    };
    EXPECT_LE(largest("stiffness inverseDistance; patches (left); exponent 1.5;"), 40);
    EXPECT_EQ(largest("motionSolver feElasticity;"), 51);
}


//- A translation is kept by any stiffness; the largest displacement is on the
//  boundary; the map is linear
TEST(laplaceMotion, everyStiffnessKeepsTranslations)
{
    for (const word& type : meshStiffness::dictionaryConstructorTablePtr_->sortedToc())
    {
        SCOPED_TRACE(type);
        const string all
        (
            "stiffness " + type + "; exponent 1.5; patches (left);"
            " factors ({ stiffness distortion; } { stiffness inverseVolume; exponent 2; });"
        );
        forMeshes(all, [&](const motionCase& c)
        {
            const vector v = c.inPlane(vector(0.3, -2, 0.7));
            const vectorField u(c.extend([&](const point&) { return v; }));
            forAll(u, n) EXPECT_LT(mag(u[n] - v), 1e-12);

            const List<scalarField> kappa = stiffness(c.fe, all);
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


//- Planes along the axes leave the components uncoupled: matrices of scalars,
//  with the displacements of the same mesh turned, which is a problem of a vector
TEST(laplaceMotion, planesAlongTheAxesCoupleNothing)
{
    const scalar angle = 0.4;
    const tensor turn(::cos(angle), -::sin(angle), 0, ::sin(angle), ::cos(angle), 0, 0, 0, 1);
    const auto turned = [&](const point& p) { return turn & p; };
    const auto straight = [](const point& p) { return p; };
    for (const bool plane : {true, false}) for (const label order : {1, 2})
    {
        HashTable<word> types;
        types.set("left", "symmetryPlane");
        types.set("bottom", "symmetryPlane");
        if (!plane) types.set("back", "symmetryPlane");
        const string dict("stiffness inverseVolume;");
        const motionCase a("hex", order, plane, dict, straight, types), b("hex", order, plane, dict, turned, types);
        const auto pull = [](const point& x) { return vector(0.1*x.y(), 0.2*sqr(x.x()), 0.1*x.x()*x.y()); };

        const vectorField u(a.extend(pull));
        const vectorField v(b.extend([&](const point& x) { return turn & pull(turn.T() & x); }));
        forAll(u, n) EXPECT_LT(mag((turn & u[n]) - v[n]), 1e-13);

        const auto nonzeros = [](const motionCase& c)
        {
            scalar sum = 0;
            for (const feLinearSolver* solver : c.motion->solvers()) sum += solver->stats().nNonzeros;
            return sum;
        };
        const label dim = a.fe.dim();
        EXPECT_EQ(a.motion->solvers().size(), dim);
        EXPECT_EQ(b.motion->solvers().size(), 1);
        EXPECT_LT(nonzeros(a), 1.1*nonzeros(b)/(dim - 1));
    }
}


namespace
{

//- A sector of a shell 0.5 <= r <= 1 about the z axis or about the origin, of
//  which the outer side slides along its surface
struct shellCase
{
    shapeMesh box;
    feMesh fe;
    pointVectorField field;
    autoPtr<meshMotion> motion;

    static point place(const point& p, const bool sphere)
    {
        const scalar r = 0.5 + 0.5*p.x(), a = 0.3 + 1.2*p.y(), b = 2 - 1.2*p.z();
        return sphere
          ? r*point(::cos(a)*::sin(b), ::sin(a)*::sin(b), ::cos(b))
          : point(r*::cos(a), r*::sin(a), p.z());
    }

    static string conditions(const bool sphere)
    {
        const string free("{ type calculated; }"), ends(sphere ? free : "{ type slip; }"),
            surface(sphere ? "sphere; centre (0 0 0);" : "cylinder; point (0 0 0); axis (0 0 1);");
        return
            "dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0); boundaryField { left { type fixedValue; value uniform (0 0 0); }"
            " right { type surfaceSlip; surface { type " + surface + " radius 1; } value uniform (0 0 0); }"
            " bottom " + free + " top " + free + " back " + ends + " front " + ends + " }";
    }

    shellCase(const char* cell, const bool sphere, const string& dict)
    :
        box(cell, {3, 4, 3}, [=](const point& p) { return place(p, sphere); }),
        fe(box.mesh(), 1, dictionary()),
        field
        (
            IOobject("pointDisplacement", "0", box.mesh()), pointMesh::New(box.mesh()),
            entries(conditions(sphere))
        ),
        motion(meshMotion::New(fe, &field, labelList(), motionCase::coeffs(dict), entries("type MUMPS;")))
    {}

    //- Turn the inner side about an axis; largest distance of the outer one from
    //  its surface
    scalar step(const vector& axis, const scalar angle, const bool settled, vectorField& u)
    {
        motion->adapt(u);
        motion->renew();
        const tensor K(0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0);
        const tensor turn(::sin(angle)*K + (1 - ::cos(angle))*(K & K));
        forAll(u, n) if (motion->given(n)) u[n] = turn & fe.points()[n];
        EXPECT_TRUE(motion->extend(u));
        settled ? motion->settle(u) : fe.toPoints<vector>(u, field.primitiveFieldRef());

        const label outer = box.mesh->boundaryMesh().findPatchID("right");
        const auto& surface = dynamic_cast<const nodalSurface&>(field.boundaryField()[outer]);
        scalar off = 0;
        for (const label n : fe.patchNodes(outer)) off = max(off, mag(surface.placeOf(fe.points()[n] + u[n]).gap));
        return off;
    }
};

} // End anonymous namespace


//- Nodes slide along a cylinder and a sphere, and along the edge of a cylinder
//  and a plane, far enough to be tied in other components
TEST(nodalMotion, nodesSlideAlongSurfaces)
{
    for (const bool sphere : {false, true}) for (const char* cell : {"hex", "tet"})
    {
        for (const char* dict : {"stiffness uniform;", "motionSolver feElasticity; stiffness uniform;"})
        {
            shellCase c(cell, sphere, dict);
            const vector axis(sphere ? vector(1, -1, 1)/::sqrt(3.0) : vector(0, 0, 1));
            vectorField u(c.fe.nNodes(), Zero);
            for (label k = 1; k <= 8; ++k) EXPECT_LT(c.step(axis, 0.15*k, true, u), 1e-12);
            scalar way = 0;
            for (const label n : c.fe.patchNodes(c.box.mesh->boundaryMesh().findPatchID("right")))
            {
                way = max(way, mag(u[n]));
                if (!sphere && mag(c.fe.points()[n].z() - 0.5) > 0.49) EXPECT_NEAR(u[n].z(), 0, 1e-13);
            }
            EXPECT_GT(way, 0.4);
        }
    }
}


//- Within a step the motion is linear: off the surface by the square of a
//  step's way, which does not add up
TEST(nodalMotion, aStepAlongASurfaceIsAlongItsPlane)
{
    shellCase c("hex", true, "stiffness uniform;");
    vectorField u(c.fe.nNodes(), Zero);
    scalar off = 0;
    for (label k = 1; k <= 40; ++k) off = max(off, c.step(vector(0, 0, 1), 0.02*k, false, u));
    EXPECT_LT(off, 0.5*sqr(0.02)*1.05);
    EXPECT_GT(off, 1e-6);

    // At rest all come to it
    for (label k = 0; k < 10; ++k) off = c.step(vector(0, 0, 1), 0.8, false, u);
    EXPECT_LT(off, 1e-9);
}


//- Errors of the condition
TEST(surfaceSlip, complains)
{
    shapeMesh box("hex", {2, 2, 1}, [](const point& p) { return p; }, shapeMesh::twoD());
    const auto field = [&](const string& surface, const string& dims)
    {
        pointVectorField u
        (
            IOobject("pointDisplacement", "0", box.mesh()), pointMesh::New(box.mesh()),
            entries
            (
                "dimensions " + dims + "; internalField uniform (0 0 0); boundaryField { \"(back|front)\" { type empty; } \"(bottom|top|left)\""
                " { type calculated; } right { type surfaceSlip; " + surface + " value uniform (0 0 0); } }"
            )
        );
        const feMesh fe(box.mesh(), 1, dictionary());
        const nodalBoundary boundary(fe, u);
    };
    const auto says = [&](const string& surface, const string& dims, const char* what)
    {
        const std::string message(complaint([&]() { field(surface, dims); }));
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    const string length("[0 1 0 0 0 0 0]"), cylinder("surface { type cylinder; point (0 0.5 0); axis (0 0 1); radius 1.1; }");
    says("surface { type sphere; centre (0 0.5 0); radius 1.1; }", length, "the normal of a 2-D case");
    says("surface { type torus; }", length, "torus");
    says(cylinder, "[0 1 -1 0 0 0 0]", "expected a displacement");

    const bool throwing = FatalError.throwExceptions();
    EXPECT_THROW(field(cylinder, length), Foam::error);
    FatalError.throwExceptions(throwing);
}


TEST(meshStiffness, isOfTheMeasureItSays)
{
    // Cells of sizes 1 : 2 along x
    const auto graded = [](const point& p) { return point(p.x() < 0.6 ? p.x() : 0.5 + 2*(p.x() - 0.5), p.y(), p.z()); };
    const shapeMesh box("hex", {2, 1, 1}, graded, shapeMesh::twoD());
    const feMesh fe(box.mesh(), 1, dictionary());
    const auto ratio = [&](const string& dict)
    {
        const scalarField k(stiffness(fe, dict)[0]);
        return k[0]/k[1];
    };
    EXPECT_NEAR(ratio("stiffness uniform;"), 1, 1e-14);
    EXPECT_NEAR(ratio("stiffness inverseVolume;"), 2, 1e-12);
    EXPECT_NEAR(ratio("stiffness inverseVolume; exponent 2;"), 4, 1e-12);
    EXPECT_NEAR(ratio(""), 1, 1e-12);
    EXPECT_NEAR
    (
        ratio("stiffness product; factors ({ stiffness inverseVolume; } { stiffness inverseVolume; exponent 2; });"),
        8, 1e-11
    );

    // Centres (0.25 0.5) and (1 0.5), the patch's nodes (0 0) and (0 1)
    EXPECT_NEAR(ratio("stiffness inverseDistance; patches (left);"), 2, 1e-12);
    EXPECT_NEAR(ratio("stiffness inverseDistance; patches (left); exponent 3;"), 8, 1e-11);

    // l^2/V: sides 0.5 x 1 and 1 x 1
    EXPECT_NEAR(ratio("stiffness distortion;"), (0.3125/0.5)/(0.5/1), 1e-12);
}


//- In a channel that widens threefold the amplitude of kappa = |grad phi|^2 falls
//  as width^(-1/3), kappa as width^(-2/3)
TEST(meshStiffness, autoSpreadsTheMotion)
{
    const auto widening = [](const point& p) { return point(p.x(), (p.y() - 0.5)*0.02*(1 + 2*p.x()), p.z()); };
    for (const char* cell : {"hex", "prism"})
    {
        const shapeMesh box(cell, {40, 2, 1}, widening, shapeMesh::twoD());
        const feMesh fe(box.mesh(), 1, dictionary());
        const auto nodes = [&](const word& patch) { return fe.patchNodes(box.mesh->boundaryMesh().findPatchID(patch)); };
        const scalarField k(stiffness(fe, "stiffness auto;", {nodes("left"), nodes("right"), entries("type MUMPS;")})[0]);
        EXPECT_NEAR(max(k)/min(k), Foam::pow(3.0, 2.0/3), 0.1);
    }
}


//- The measures of elements that have moved
TEST(meshStiffness, ofMovedElements)
{
    const shapeMesh box("hex", {2, 1, 1}, [](const point& p) { return p; }, shapeMesh::twoD());
    const feMesh fe(box.mesh(), 1, dictionary());
    vectorField x(fe.points());
    for (vector& p : x) if (mag(p.x() - 0.5) < SMALL) p.x() = 0.2;
    const autoPtr<meshStiffness> s(meshStiffness::New(fe, motionWalls(), entries("stiffness inverseVolume;"), {}));
    const scalarField k(s->elements(x)[0]);
    EXPECT_NEAR(k[0]/k[1], 4, 1e-12);
}


TEST(meshMotion, complains)
{
    const auto of = [](const string& dict) { return complaint([&]() { motionCase("hex", 1, true, dict); }); };
    const string elastic("motionSolver feElasticity; ");
    EXPECT_NE(of("configuration updated;").find("incremental"), std::string::npos) << of("configuration updated;");
    EXPECT_NE(of(elastic + "model rubber;").find("neoHookean"), std::string::npos);
    EXPECT_NE(of(elastic + "poissonRatio 0.5;").find("from 0 to less than 0.5"), std::string::npos);
    EXPECT_NE(of(elastic + "configuration incremental;").find("is for model linear"), std::string::npos);
    EXPECT_NE(of("motionSolver displacementLaplacian;").find("feElasticity"), std::string::npos);
    EXPECT_NE(of("stiffness product; factors ({ stiffness soft; });").find("inverseDistance"), std::string::npos);
}


TEST(meshStiffness, complains)
{
    const shapeMesh box("hex", {2, 1, 1}, distorted, shapeMesh::twoD());
    const feMesh fe(box.mesh(), 1, dictionary());
    const auto of = [&](const string& dict)
    {
        return complaint([&]() { stiffness(fe, dict); });
    };
    EXPECT_NE(of("stiffness soft;").find("inverseDistance"), std::string::npos) << of("stiffness soft;");
    EXPECT_NE(of("zones { near 3; }").find("no cellZone 'near'"), std::string::npos);
    EXPECT_NE(of("stiffness inverseDistance; patches (flag);").find("no patch 'flag'"), std::string::npos);
    EXPECT_NE(of("stiffness inverseVolume; exponent 1e3;").find("from 0 to 10"), std::string::npos);
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
    const scalarField k(stiffness(fe, "stiffness uniform; zones { near 3; }")[0]);
    EXPECT_EQ(k[0], 3);
    EXPECT_EQ(k[1], 1);

    for (const string factor : {"0", "-2", "{}"})
    {
        const string dict("zones { near " + factor + (factor == "{}" ? "" : ";") + " }");
        const std::string message(complaint([&]() { stiffness(fe, dict); }));
        EXPECT_NE(message.find("cellZone near under zones is no number > 0"), std::string::npos) << message;
    }
}


int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //
