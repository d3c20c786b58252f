-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: where the thresholds of OSACSS come from.

return {
    ["nothing, ooze, stream; figures are a proposal"] = "rien, suintement, jet ; les valeurs sont une proposition",
    ["Mackool & Russell 1996: strong from 2.0 mm at 3.0 to 3.5 mm width; Ernest 1994: square wounds hold far better"] =
        "Mackool et Russell 1996 : solide dès 2,0 mm pour 3,0 à 3,5 mm de large ; Ernest 1994 : les incisions "
            .. "carrées tiennent bien mieux",
    ["Hejsek 2019 for the range of pressures during surgery"] = "Hejsek 2019 pour les pressions pendant l'opération",
    ["proposal; a needle dents the capsule by up to 0.3 mm before it is through"] =
        "proposition ; l'aiguille enfonce la capsule de 0,3 mm au plus avant de la percer",
    ["Packer 2015: 5.25 mm; Findl and others: 4.5 to 5.5 mm"] = "Packer 2015 : 5,25 mm ; Findl et coll. : 4,5 à 5,5 mm",
    ["0.88 in live surgery (ImmersiveTouch study)"] = "0,88 en chirurgie réelle (étude ImmersiveTouch)",
    ["Raval 2020: experts 3.9 to 6.5; ImmersiveTouch study: residents 10.3"] =
        "Raval 2020 : experts 3,9 à 6,5 ; étude ImmersiveTouch : internes 10,3",
    ["experts 29 to 42 s (Raval 2020), residents 94 s"] = "experts 29 à 42 s (Raval 2020), internes 94 s",
    ["Joshi 2019: 0.71 ml from one site, 1.7 ml from several"] =
        "Joshi 2019 : 0,71 ml d'un seul point, 1,7 ml de plusieurs",
    ["Riviere 1997: 49 um holding still, 133 um while actuating"] =
        "Riviere 1997 : 49 µm au repos, 133 µm pendant l'action",
    ["teaching rule of 80 to 90 %; teachers differ"] = "règle d'enseignement de 80 à 90 % ; les enseignants divergent",
    ["proposal; five points from 70 % on, the deeper one from 80 %"] =
        "proposition ; cinq points dès 70 %, le plus profond dès 80 %",
    ["90 degrees for five points is a proposal; 80 leaves room for the tolerance"] =
        "90 degrés pour cinq points est une proposition ; 80 laisse place à la tolérance",
    ["proposal; Mikielewicz 2011 for the loads of zonules"] =
        "proposition ; Mikielewicz 2011 pour les charges des zonules",
    ["Joshi 2019: 267 to 277 s; Rali 2022: 275 to 611 s"] = "Joshi 2019 : 267 à 277 s ; Rali 2022 : 275 à 611 s",
    ["Joshi 2019: 75 s; Rali 2022: 244 s early"] = "Joshi 2019 : 75 s ; Rali 2022 : 244 s au début",
    ["Ashena 2020: 0.2 to 0.3 mm go unnoticed; the rest: proposal"] =
        "Ashena 2020 : 0,2 à 0,3 mm passent inaperçus ; le reste : proposition",
    ["Ashena 2020: 2 to 3 degrees go unnoticed; the rest: proposal"] =
        "Ashena 2020 : 2 à 3 degrés passent inaperçus ; le reste : proposition",
    ["Auffarth 2013: rims in pigs' eyes break at 1.35; the rest: proposal"] =
        "Auffarth 2013 : chez le porc, le bord cède à 1,35 ; le reste : proposition",
    ["ASCRS 2014: tests with up to an ounce, 0.28 N; figures are a proposal"] =
        "ASCRS 2014 : essais jusqu'à une once, 0,28 N ; les valeurs sont une proposition",
    ["proposal; Din 2016: novices about twice as far from the middle as experts"] =
        "proposition ; Din 2016 : débutants environ deux fois plus loin du centre que les experts",
    ["proposal; depth of field by Berek's formula: docs/picture.md"] =
        "proposition ; profondeur de champ selon Berek : docs/picture.md",
    ["proposal; collagen shrinks from 60 degrees C on (EyeWiki)"] =
        "proposition ; le collagène se rétracte dès 60 °C (EyeWiki)",
    ["15, 25 and 40 min of a whole operation; BMJ Open 2013: seniors 13.4, juniors 17.8 min"] =
        "15, 25 et 40 min pour l'opération entière ; BMJ Open 2013 : confirmés 13,4, débutants 17,8 min",
    ["proposal; Smith 2013: path length separates under 200 from over 1000 cases"] =
        "proposition ; Smith 2013 : le trajet sépare moins de 200 et plus de 1000 opérations",
    ["proposal; Smith 2013: movements separate under 200 from over 1000 cases"] =
        "proposition ; Smith 2013 : les gestes séparent moins de 200 et plus de 1000 opérations",
    ["proposal; measured by Mikhail 2025, without thresholds"] = "proposition ; mesuré par Mikhail 2025, sans seuils",
}
