/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the measures of elements.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "runOnRanks.H"
#include "qualityLimits.H"
#include "jacobianBound.H"
#include "IStringStream.H"
#include <random>

using namespace Foam;

namespace
{

//- Call f(element) for all elements of 2-D and 3-D
template<class F>
void forElements(const F& f)
{
    f(Tri1()); f(Tri2()); f(Quad1()); f(Quad2());
    f(Tet1()); f(Tet2()); f(Hex1()); f(Hex2()); f(Prism1()); f(Pyramid1());
}

//- The scaled Jacobian at a place of the lattice's domain
template<class E>
scalar scaledJacobian(const Vec<double, E::dim>* x, const double* xi)
{
    typedef jacobianLattice<E> L;
    constexpr int d = E::dim;
    Vec<double, d> J[d];
    L::columns(x, xi, J);
    Ten<double, d> T;
    for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b) T(a, b) = J[b][a];
    scalar least = GREAT;
    for (int s = 0; s < L::nSets; ++s)
    {
        scalar p = det(T)/L::regular;
        for (int k = 0; k < d; ++k)
        {
            Vec<double, d> t = Vec<double, d>::zero();
            for (int b = 0; b < d; ++b) t += J[b]*L::direction[L::set[s][k]][b];
            p /= Foam::sqrt(t & t);
        }
        least = min(least, p);
    }
    return least;
}

//- A random place in the lattice's domain, often on its boundary
template<class E, class R>
void place(R& random, double* xi)
{
    typedef jacobianLattice<E> L;
    std::uniform_real_distribution<double> u(0, 1);
    double l[4], sum = 0;
    for (int a = 0; a <= L::simplex; ++a) sum += l[a] = u(random) < 0.4 ? 0 : u(random);
    for (int a = 0; a < L::simplex; ++a) xi[a] = sum > 0 ? l[a]/sum : 0;
    for (int a = L::simplex; a < E::dim; ++a)
    {
        xi[a] = u(random) < 0.5 ? 2*u(random) - 1 : u(random) < 0.5 ? -1 : 1;
    }
}

elementQuality qualityOf(const word& cell, const bool plane, const shapeMesh::pointMap& map)
{
    const shapeMesh box(cell, {1, 1, 1}, map, plane ? shapeMesh::twoD() : HashTable<word>());
    const feMesh fe(box.mesh(), 1, dictionary());
    return qualities(fe, fe.points())[0][0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- Below all samples, and not far below the least of many
TEST(jacobianBound, isABound)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 1);
    forElements([&](auto element)
    {
        typedef decltype(element) E;
        SCOPED_TRACE(E::name);
        jacobianBound<E> bound;
        label nValid = 0;
        for (const scalar amplitude : {0.0, 0.02, 0.05, 0.1, 0.15, 0.3}) for (label trial = 0; trial < 10; ++trial)
        {
            Vec<double, E::dim> x[E::nNodes];
            for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
            {
                x[i][a] = E::xi[i][a] + amplitude*noise(random);
            }
            const scalar b = bound(x);
            scalar least = GREAT;
            for (label k = 0; k < 4000; ++k)
            {
                double xi[3];
                place<E>(random, xi);
                least = min(least, scaledJacobian<E>(x, xi));
            }
            if (b <= 0)
            {
                EXPECT_LT(least, 0.03);
                continue;
            }
            ++nValid;
            EXPECT_LE(b, least + 1e-12);
            EXPECT_GE(b, least - 0.03);
        }
        EXPECT_GE(nValid, 15);
    });
}


TEST(elementQuality, ofRegularShapes)
{
    // A brick of two triangles of which both are regular
    const auto regular = [](const point& p) { return point(p.x() - 0.5*p.y(), 0.5*Foam::sqrt(3.0)*p.y(), p.z()); };
    const elementQuality tri = qualityOf("prism", true, regular);
    EXPECT_NEAR(tri.aspectRatio, 1, 1e-12);
    EXPECT_NEAR(tri.scaledJacobian, 1, 1e-12);
    EXPECT_NEAR(tri.minAngle, 60, 1e-10);
    EXPECT_NEAR(tri.maxAngle, 60, 1e-10);

    const elementQuality hex = qualityOf("hex", false, [](const point& p) { return 3*p; });
    EXPECT_NEAR(hex.volume, 27, 1e-11);
    EXPECT_NEAR(hex.aspectRatio, 1, 1e-12);
    EXPECT_NEAR(hex.scaledJacobian, 1, 1e-12);
    EXPECT_NEAR(hex.minAngle, 90, 1e-10);

    // Edges 1, 1, 1, sqrt 2, sqrt 2, sqrt 3; at the short ones angles of 90, 45, 60 degrees
    const elementQuality tet = qualityOf("tet", false, [](const point& p) { return p; });
    const scalar l = (3 + 2*Foam::sqrt(2.0) + Foam::sqrt(3.0))/6;
    EXPECT_NEAR(tet.aspectRatio, l*l*l*6/(6*Foam::sqrt(2.0)), 1e-12);
    EXPECT_NEAR(tet.minAngle, 45, 1e-10);
    EXPECT_NEAR(tet.maxAngle, 90, 1e-10);

    const elementQuality prism = qualityOf("prism", false, [&](const point& p) { return regular(p); });
    EXPECT_NEAR(prism.aspectRatio, 1, 1e-12);
    EXPECT_NEAR(prism.scaledJacobian, 1, 1e-12);

    // Six pyramids of a cube: base 1, height 1/2; edges 1 and sqrt(3)/2
    const elementQuality pyramid = qualityOf("pyr", false, [](const point& p) { return p; });
    EXPECT_NEAR(pyramid.volume, 1.0/6, 1e-12);
    EXPECT_NEAR(pyramid.minAngle, 45, 1e-10);
    EXPECT_NEAR(pyramid.maxAngle, 120, 1e-10);
    EXPECT_NEAR(pyramid.scaledJacobian, 0.5/(0.5*Foam::sqrt(3.0))*Foam::sqrt(2.0), 0.02);
}


TEST(elementQuality, changesOfVolumeAndAspectRatio)
{
    const auto of = [](const scalar a, const scalar b)
    {
        return qualityOf("hex", true, [=](const point& p) { return point(a*p.x(), b*p.y(), p.z()); });
    };
    const elementQuality reference = of(1, 1), half = of(1, 0.5), twice = of(2, 1);
    EXPECT_NEAR(half.VOCH(reference), 2, 1e-12);
    EXPECT_NEAR(twice.VOCH(reference), 2, 1e-12);

    // l^2/V = 0.75^2/0.5
    EXPECT_NEAR(half.ARCH(reference), 1.125, 1e-12);
    EXPECT_NEAR(reference.ARCH(half), 1.125, 1e-12);

    const elementQuality inverted = {-1, GREAT, -1, 10, 170};
    EXPECT_EQ(inverted.VOCH(reference), GREAT);
    EXPECT_EQ(inverted.ARCH(reference), GREAT);
}


//- One node goes towards the opposite side and has 0.3 of the way gone
TEST(elementQuality, forecastOfAnInversion)
{
    for (const bool plane : {true, false}) for (const char* cell : {"hex", "prism"}) for (const label order : {1, 2})
    {
        if (!plane && word(cell) == "prism" && order == 2) continue;
        const shapeMesh box(cell, {2, 2, 2 - plane}, [](const point& p) { return p; },
            plane ? shapeMesh::twoD() : HashTable<word>());
        const feMesh fe(box.mesh(), order, dictionary());

        // Compressed towards x = 0: lost when all is there
        const auto closing = [&](const scalar rate) { vectorField dx(rate*fe.points()); forAll(dx, n) dx[n].y() = dx[n].z() = 0; return dx; };
        EXPECT_NEAR(forecast(fe, fe.points(), closing(-0.05)).steps, 20, 1e-6);
        EXPECT_GE(forecast(fe, fe.points(), closing(0.05)).steps, GREAT);
        EXPECT_GE(forecast(fe, fe.points(), vectorField(fe.nNodes(), vector(1, 2, 0))).steps, GREAT);

        // Turned by a little as a whole: inverted by nothing
        vectorField turn(fe.nNodes());
        forAll(turn, n) turn[n] = 0.01*(vector(0, 0, 1) ^ fe.points()[n]);
        EXPECT_GE(forecast(fe, fe.points(), turn).steps, 1e6);
    }
}


TEST(qualityLimits, countsAndComplains)
{
    const auto limits = [](const string& text)
    {
        IStringStream is(text);
        return qualityLimits(dictionary(is));
    };
    const elementQualities now({{{1, 1, 0.9, 80, 100}, {1, 3, 0.05, 30, 150}}}), then({{{1, 1, 1, 90, 90}, {3, 1, 1, 90, 90}}});
    EXPECT_EQ(limits("").nBroken(now, then), labelList(6, 0));
    EXPECT_EQ
    (
        limits("scaledJacobian 0.1; aspectRatio 2; VOCH 2; ARCH 2; minAngle 20; maxAngle 140;").nBroken(now, then),
        labelList({1, 1, 1, 1, 0, 1})
    );

    const bool throwing = FatalIOError.throwExceptions();
    std::string message;
    try { limits("aspectRatio -2;"); }
    catch (const Foam::IOerror& error) { message = error.message(); }
    FatalIOError.throwExceptions(throwing);
    EXPECT_NE(message.find("limit aspectRatio is -2, expected a number > 0"), std::string::npos) << message;
}


// ************************************************************************* //
