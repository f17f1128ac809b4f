/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::neoHookean

Description
    Compressible neo-Hookean material:

        W = mu/2 (tr C - 3 - 2 ln J) + lambda/4 (J^2 - 1 - 2 ln J)
        P = mu (F - F^-T) + lambda/2 (J^2 - 1) F^-T

    C = F^T F, J = det F. Other codes split W into isochoric and volumetric
    parts: the results differ, in Cook's membrane at nu = 0.35 by 0.5 %.

Usage
    \verbatim
    rubber
    {
        type    neoHookean;
        rho     1100;           // kg/m3
        E       200;            // Pa; or mu and lambda
        nu      0.35;
    }
    \endverbatim

    Source: P. Wriggers, Nonlinear Finite Element Methods (2008), section 3.3.1.
\*---------------------------------------------------------------------------*/

#include "elasticModuli.H"
#include "solidMaterialOf.H"

namespace Foam
{
namespace solidLaws
{

struct neoHookean : elasticModuli
{
    using elasticModuli::elasticModuli;

    template<class T, int d>
    T W(const Ten<T, d>& F) const
    {
        using std::log;
        const T J = det(F), lnJ = log(J), trC = trPlaneStrain(Ten<T, d>(F.t() & F));
        return 0.5*mu*(trC - 3.0 - 2.0*lnJ) + 0.25*lambda*(J*J - 1.0 - 2.0*lnJ);
    }

    template<class T, int d>
    Ten<T, d> P(const Ten<T, d>& F) const
    {
        const T J = det(F);
        const Ten<T, d> FinvT = inv(F, J).t();
        return mu*(F - FinvT) + (0.5*lambda*(J*J - 1.0))*FinvT;
    }

    //- dJ = J F^-T:dF,   d(F^-T) = -F^-T dF^T F^-T
    template<class T, int d>
    Ten<T, d> dP(const Ten<T, d>& F, const Ten<T, d>& dF) const
    {
        const T J = det(F);
        const Ten<T, d> FinvT = inv(F, J).t(), dFinvT = -1.0*(FinvT & (dF.t() & FinvT));
        return
            mu*(dF - dFinvT) + (0.5*lambda*(J*J - 1.0))*dFinvT
          + (lambda*J*J*(FinvT && dF))*FinvT;
    }
};

registerSolidMaterial(neoHookean);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
