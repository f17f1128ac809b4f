/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestWord.H"
#include <cctype>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::editDistance(const std::string& a, const std::string& b)
{
    const label nA = a.size(), nB = b.size();
    const auto same = [&](const label i, const label j)
    {
        return std::tolower(a[i - 1]) == std::tolower(b[j - 1]);
    };

    // Of the first i characters of a and the first j of b
    List<labelList> d(nA + 1, labelList(nB + 1, 0));
    for (label i = 0; i <= nA; ++i) d[i][0] = i;
    for (label j = 0; j <= nB; ++j) d[0][j] = j;

    for (label i = 1; i <= nA; ++i) for (label j = 1; j <= nB; ++j)
    {
        d[i][j] = min(d[i-1][j], d[i][j-1]) + 1;
        d[i][j] = min(d[i][j], d[i-1][j-1] + (same(i, j) ? 0 : 1));
        if (i > 1 && j > 1 && same(i, j-1) && same(i-1, j))
        {
            d[i][j] = min(d[i][j], d[i-2][j-2] + 1);
        }
    }
    return d[nA][nB];
}


Foam::word Foam::nearestWord(const std::string& name, const wordList& words)
{
    word nearest;
    label smallest = labelMax;
    for (const word& w : words)
    {
        const label d = editDistance(name, w);
        if (d < smallest && 2*d < label(max(name.size(), w.size())))
        {
            nearest = w;
            smallest = d;
        }
    }
    return nearest;
}


// ************************************************************************* //
