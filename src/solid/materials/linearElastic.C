/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::linearElastic

Description
    Small strains, the displacement's gradient beside 1:

        W = lambda/2 tr(e)^2 + mu e:e,      e = (F + F^T)/2 - I
        P = lambda tr(e) I + 2 mu e

    Forces do not depend on the displacements beyond proportion, and a rotation
    by phi makes strains of the size phi^2/2: for large displacements take
    StVenantKirchhoff.

Usage
    \verbatim
    block
    {
        type    linearElastic;
        rho     7800;           // kg/m3
        E       2.1e11;         // Pa; or mu and lambda
        nu      0.3;
    }
    \endverbatim

    Source: O.C. Zienkiewicz, R.L. Taylor, The Finite Element Method, vol. 1.
\*---------------------------------------------------------------------------*/

#include "elasticModuli.H"
#include "solidMaterialOf.H"

namespace Foam
{
namespace solidLaws
{

struct linearElastic : elasticModuli
{
    using elasticModuli::elasticModuli;

    template<class T, int d>
    T W(const Ten<T, d>& F) const
    {
        const Ten<T, d> e = 0.5*(F + F.t()) - Ten<T, d>::I();
        const T tre = tr(e);
        return 0.5*lambda*tre*tre + mu*(e && e);
    }

    template<class T, int d>
    Ten<T, d> P(const Ten<T, d>& F) const
    {
        return stress(Ten<T, d>(F - Ten<T, d>::I()));
    }

    template<class T, int d>
    Ten<T, d> dP(const Ten<T, d>&, const Ten<T, d>& dF) const
    {
        return stress(dF);
    }


private:

    template<class T, int d>
    Ten<T, d> stress(const Ten<T, d>& gradD) const
    {
        return (mu*(gradD + gradD.t())).addDiag(lambda*tr(gradD));
    }
};


struct linearElasticMaterial : solidMaterialOf<linearElastic>
{
    using solidMaterialOf<linearElastic>::solidMaterialOf;

    bool ofStretches() const override { return false; }
};

addNamedToRunTimeSelectionTable(solidMaterial, linearElasticMaterial, dictionary, linearElastic);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
