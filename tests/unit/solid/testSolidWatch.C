/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of what is watched at large strains: stability of laws, hourglass modes
    of enhanced strains.
\*---------------------------------------------------------------------------*/

#include "solidWatch.H"
#include "enhancedKernel.H"
#include "materialLaw.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

autoPtr<solidMaterial> law(const char* entries)
{
    IStringStream is(entries);
    return solidMaterial::New(dictionary(is));
}


//- Of a square (cube) of side 1 under the stretches l along x, m along y
template<class E>
scalar hourglassStiffness(const solidMaterial& material, const scalar l, const scalar m)
{
    const materialLaw of(material);
    enhancedKernel<pack, E, materialLaw> kernel(of);
    solidNodes<pack, E> n;
    for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
    {
        n.X[i][a] = pack(0.5*E::xi[i][a]);
        n.D[i][a] = pack(((a == 0 ? l : a == 1 ? m : 1) - 1)*0.5*E::xi[i][a]);
    }
    return kernel.hourglassStiffness(n)[0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- tau = E/2 (l^4 - l^2) without Poisson's ratio: its slope after ln l is nil at
//  l = 1/sqrt(2)
TEST(solidWatch, findsWhereStVenantKirchhoffSoftens)
{
    const autoPtr<solidMaterial> steel = law("type StVenantKirchhoff; rho 1; E 1; nu 0;");
    EXPECT_TRUE(solidWatch::stable(steel(), false, vector(1, 1, 0.708)));
    EXPECT_FALSE(solidWatch::stable(steel(), false, vector(1, 1, 0.706)));
    EXPECT_FALSE(solidWatch::stable(steel(), false, vector(0.706, 1, 1)));
}


//- tau_i = 2 c1 l_i^2 - 2 c2/l_i^2 - p: with h = (a, -a, 0), l = (l, 1/l, 1) the
//  stiffness is 4 (c1 + c2) (l^2 + 1/l^2)
TEST(solidWatch, findsWhereMooneyRivlinSoftens)
{
    const autoPtr<solidMaterial> rubber = law("type MooneyRivlin; rho 1; c1 1; c2 -0.2;");
    EXPECT_TRUE(solidWatch::stable(rubber(), true, vector(1.3, 1, 1/1.3)));

    // Equibiaxial: 2 c1 l^2 - 2 c2/l^2 - (2 c1/l^4 - 2 c2 l^4) over h = ln l rises as
    // 4 c1 (l^2 + 2/l^4) + 4 c2 (1/l^2 + 2 l^4) does
    const auto rises = [](const scalar l)
    {
        return sqr(l) + 2/pow4(l) - 0.2*(1/sqr(l) + 2*pow4(l)) > 0;
    };
    for (const scalar l : {1.1, 1.3, 1.5, 1.6, 1.7, 2.0})
    {
        EXPECT_EQ(solidWatch::stable(rubber(), true, vector(l, l, 1/sqr(l))), rises(l)) << l;
    }
}


TEST(solidWatch, leavesStableLawsAlone)
{
    const autoPtr<solidMaterial> soft = law("type neoHookean; rho 1; E 1; nu 0.3;");
    const autoPtr<solidMaterial> rubber = law("type isochoricNeoHookean; rho 1; mu 1; bulkModulus 1000;");
    for (const vector& l : {vector(3, 1, 0.3), vector(0.4, 0.4, 0.4), vector(2, 2, 2), vector(5, 1, 1)})
    {
        EXPECT_TRUE(solidWatch::stable(soft(), false, l)) << l.x();
        EXPECT_TRUE(solidWatch::stable(rubber(), true, l)) << l.x();
    }
}


//- At small strains it is that of the bending modes; under compression it is lost,
//  soon where a stiff volume is compressed
TEST(solidWatch, findsHourglassModesWithoutStiffness)
{
    const autoPtr<solidMaterial> soft = law("type neoHookean; rho 1; E 1; nu 0.3;");
    const autoPtr<solidMaterial> stiff = law("type neoHookean; rho 1; E 1; nu 0.49;");
    const auto lost = [](auto tag, const solidMaterial& material, const bool free)
    {
        scalar l = 1;
        while (l > 0.05 && hourglassStiffness<decltype(tag)>(material, l, free ? 1/l : 1) > 0) l -= 0.01;
        return l;
    };
    for (const auto* material : {&soft(), &stiff()})
    {
        const scalar stretches[] =
        {
            lost(Quad1(), *material, true), lost(Hex1(), *material, true),
            lost(Quad1(), *material, false), lost(Hex1(), *material, false)
        };
        Info<< "    hourglass modes lose their stiffness at the stretches " << stretches[0] << ", "
            << stretches[1] << ", with the width kept " << stretches[2] << ", " << stretches[3] << endl;
        // Quadrilaterals that keep their volume do not
        EXPECT_LT(stretches[0], 0.1);
        for (label i = 1; i < 4; ++i)
        {
            EXPECT_GT(stretches[i], 0.4);
            EXPECT_LT(stretches[i], 0.99);
        }
    }
}


// ************************************************************************* //
