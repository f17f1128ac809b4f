/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::StVenantKirchhoff

Description
    Linear elastic material with geometric nonlinearity, section 2 of Zhang and
    Zhu:

        W = lambda/2 tr(E)^2 + mu E:E,    E = (F^T F - I)/2
        P = F S,    S = lambda tr(E) I + 2 mu E

    For large displacements and small strains: it softens under compression.

Usage
    \verbatim
    flag
    {
        type    StVenantKirchhoff;
        rho     1000;           // kg/m3
        E       1.4e6;          // Pa; or mu and lambda
        nu      0.4;
    }
    \endverbatim

    Source: J. Bonet, R.D. Wood, Nonlinear Continuum Mechanics for Finite
    Element Analysis, 2nd ed. (2008), section 6.4.
\*---------------------------------------------------------------------------*/

#include "elasticModuli.H"
#include "solidMaterialOf.H"

namespace Foam
{
namespace solidLaws
{

struct StVenantKirchhoff : elasticModuli
{
    using elasticModuli::elasticModuli;

    template<class T, int d>
    T W(const Ten<T, d>& F) const
    {
        const Ten<T, d> E = strain(F);
        const T trE = tr(E);
        return 0.5*lambda*trE*trE + mu*(E && E);
    }

    template<class T, int d>
    Ten<T, d> P(const Ten<T, d>& F) const
    {
        return F & stress(strain(F));
    }

    template<class T, int d>
    Ten<T, d> dP(const Ten<T, d>& F, const Ten<T, d>& dF) const
    {
        const Ten<T, d> A = F.t() & dF, dE = 0.5*(A + A.t());
        return (dF & stress(strain(F))) + (F & stress(dE));
    }


private:

    template<class T, int d>
    static Ten<T, d> strain(const Ten<T, d>& F)
    {
        return 0.5*((F.t() & F) - Ten<T, d>::I());
    }

    //- Linear in E; plane strain: E33 = 0
    template<class T, int d>
    Ten<T, d> stress(const Ten<T, d>& E) const
    {
        return (2*mu*E).addDiag(lambda*tr(E));
    }
};

registerSolidMaterial(StVenantKirchhoff);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
