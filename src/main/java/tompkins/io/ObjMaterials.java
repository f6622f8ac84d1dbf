package tompkins.io;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.image.PictureFile;
import tompkins.io.ObjStatements.ObjMistake;
import tompkins.property.NumberText;
import tompkins.ray.Colour;
import tompkins.ray.MeshMaterial;
import tompkins.ray.PixelPicture;

/**
 * Reads the materials of a mesh (MTL files): colours in diffuse light, of highlights, opacity, and a picture of the
 * diffuse colour. Everything else is noted, and a file that cannot be read costs its materials and not the mesh.
 */
final class ObjMaterials {

    private static final Colour USUAL = Colour.grey(0.8);

    private static final String NUMBER = "(?:\\s+[-+.0-9e]+)";

    /**
     * An option before the name of a picture, and what belongs to it (MTL material format, "Options for texture maps").
     */
    private static final Pattern OPTION = Pattern.compile(
            "(-(?:type|imfchan|blend[uv]|cc|clamp|texres|boost|bm)\\s+\\S+|-mm" + NUMBER + "{2}|-[ost]" + NUMBER
                    + "{1,3})\\s+",
            Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CHARACTER_CLASS);

    /** What stands behind a key, in a line counted from 1. */
    private record Property(int line, String text) {}

    private final FileKind.Files files;
    private final ObjNotes notes;
    private final Map<String, MeshMaterial> materials = new HashMap<>();
    private final Map<String, PixelPicture> pictures = new HashMap<>();

    ObjMaterials(FileKind.Files files, ObjNotes notes) {
        this.files = files;
        this.notes = notes;
    }

    /** The material of a name, or null if there is none. */
    MeshMaterial material(String name) {
        return materials.get(name);
    }

    /** Reads one file of materials whose name may have blanks, or several, named as seen from the mesh. */
    void read(String mesh, String names) {
        String name = beside(mesh, names);
        List<String> words = ObjStatements.words(names);
        try {
            read(name, new ObjStatements(files.bytes(name, "a file of materials")));
        } catch (IOException | ObjMistake missing) {
            if (words.size() > 1 && words.stream().allMatch(ObjMaterials::endsAsUsual)) {
                words.forEach(word -> read(mesh, ObjStatements.unquoted(word)));
            } else {
                notes.add(name, "its materials are not shown: " + missing.getMessage());
            }
        }
    }

    private static boolean endsAsUsual(String name) {
        return ObjStatements.unquoted(name).toLowerCase(Locale.ROOT).endsWith(".mtl");
    }

    private void read(String file, ObjStatements statements) {
        Map<String, Property> properties = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        String material = null;
        while (statements.next()) {
            if (!statements.nextWord()) {
                continue;
            }
            if (statements.wordIs("newmtl")) {
                add(file, material, properties);
                material = statements.rest();
            } else {
                properties.put(statements.word(), new Property(statements.firstLine(), statements.rest()));
            }
        }
        add(file, material, properties);
    }

    private void add(String file, String material, Map<String, Property> properties) {
        if (material != null) {
            Colour diffuse = colour(file, properties, "Kd", USUAL);
            Colour specular = colour(file, properties, "Ks", Colour.BLACK);
            double opacity = properties.containsKey("d")
                    ? share(file, properties, "d", 1)
                    : 1 - share(file, properties, "Tr", 0);
            PixelPicture picture = picture(file, properties.remove("map_Kd"));
            if (picture != null && !specular.equals(Colour.BLACK)) {
                notes.add(file, "highlights on pictures are not shown (Ks with map_Kd)");
            }
            materials.putIfAbsent(
                    material,
                    new MeshMaterial(
                            material,
                            diffuse,
                            specular,
                            opacity,
                            picture == null ? null : picture.tinted(diffuse, opacity)));
        }
        properties.keySet().forEach(key -> notes.add(file, Problems.quoted(key) + " is not read"));
        properties.clear();
    }

    /** A number from 0 to 1. */
    private double share(String file, Map<String, Property> properties, String key, double otherwise) {
        Property property = properties.remove(key);
        double share = property == null ? otherwise : number(property.text);
        if (!(share >= 0 && share <= 1)) {
            notes.add(file, property.line, Problems.quoted(key) + " must be a number from 0 to 1", property.text);
            return otherwise;
        }
        return share;
    }

    /** Three numbers, or one for all channels. */
    private Colour colour(String file, Map<String, Property> properties, String key, Colour otherwise) {
        Property property = properties.remove(key);
        if (property == null) {
            return otherwise;
        }
        List<String> words = ObjStatements.words(property.text);
        double red = number(words.get(0));
        boolean isGrey = words.size() == 1;
        double green = isGrey ? red : number(words.get(1));
        double blue = isGrey ? red : words.size() == 3 ? number(words.get(2)) : Double.NaN;
        if (red >= 0 && green >= 0 && blue >= 0 && Math.max(red, Math.max(green, blue)) <= 1) {
            return new Colour(red, green, blue);
        }
        notes.add(file, property.line, Problems.quoted(key) + " must be three numbers from 0 to 1", property.text);
        return otherwise;
    }

    private static double number(String word) {
        try {
            return NumberText.parse(word);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    private PixelPicture picture(String file, Property property) {
        if (property == null) {
            return null;
        }
        Matcher options = OPTION.matcher(property.text);
        int start = 0;
        for (; options.lookingAt(); options.region(start, property.text.length())) {
            String option = ObjStatements.words(options.group()).get(0);
            notes.add(file, "the option " + Problems.quoted(option) + " of \"map_Kd\" is not used");
            start = options.end();
        }
        String name = beside(file, ObjStatements.unquoted(property.text.substring(start)));
        try {
            if (!pictures.containsKey(name)) {
                // also if it fails: once is enough
                pictures.put(name, null);
                pictures.put(name, PictureFile.read(files.bytes(name, "a picture file"), name));
            }
        } catch (IOException unusable) {
            notes.add(file, "a picture is not shown: " + unusable.getMessage());
        }
        return pictures.get(name);
    }

    /** The name, seen from the folder of the scene, of a file that another file names. */
    static String beside(String file, String name) {
        return file.substring(0, file.lastIndexOf('/') + 1) + name.replace('\\', '/');
    }
}
