import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Asks all types that the library shows, by way of each other, for their members, as bridges from other languages do. */
public class Shown {

    public static void main(String[] names) throws ClassNotFoundException {
        Deque<Class<?>> open = new ArrayDeque<>();
        for (String name : names) {
            open.add(Class.forName(name));
        }
        Set<Class<?>> shown = new HashSet<>();
        while (!open.isEmpty()) {
            Class<?> type = open.remove();
            if (type.isArray()) {
                open.add(type.getComponentType());
            } else if (!type.isPrimitive() && !type.getName().startsWith("java") && shown.add(type)) {
                open.addAll(List.of(type.getInterfaces()));
                open.addAll(type.isSealed() ? List.of(type.getPermittedSubclasses()) : List.of());
                for (Field each : type.getFields()) {
                    open.add(each.getType());
                }
                for (Constructor<?> each : type.getConstructors()) {
                    open.addAll(List.of(each.getParameterTypes()));
                }
                for (Method each : type.getMethods()) {
                    open.add(each.getReturnType());
                    open.addAll(List.of(each.getParameterTypes()));
                }
            }
        }
        System.out.println(shown.size() + " types, by way of each other, from " + String.join(", ", names));
    }
}
